{-# LANGUAGE Unsafe, MagicHash, UnboxedTuples #-}
import GHC.Exts

main = simulate (Say (show (I# (ord# (indexCharOffAddr# nullAddr# 0#)))))
