import GHC.RTS.Flags

main = getRTSFlags >>= \f -> simulate (Say (show f))
