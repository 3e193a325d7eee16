import GHC.Stats

main = getRTSStats >>= \s -> simulate (Say (show (max_live_bytes s)))
