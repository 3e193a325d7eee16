{-# LANGUAGE MagicHash #-}
import GHC.Exts

main = simulate wild

wild :: Velocity -> Say
wild _ = Say (show (I# (indexIntOffAddr# (int2Addr# 1#) 0#)))
