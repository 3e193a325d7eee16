{-# LANGUAGE CPP #-}
#include "CANARY"
main = simulate (Velocity 0 0)
