// Which receivers a pass lights.

#import shared/records
#import constants

// Whether it lights those that mirror light, in the lobe in which they do; else it lights all, and they reflect diffusely.
override GLOSS: bool = false;

fn is_lit(receiver: Receiver) -> bool {
    if (GLOSS) {
        return (receiver.covered >> ROUGHNESS_SHIFT & MATT) != 0u;
    }
    return receiver.covered != 0u;
}
