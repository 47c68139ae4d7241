// The whole library of an order: what `gaunt export` writes.

#import library
#import shared/exponential
#import shared/cap_log_table
#import shared/storage
