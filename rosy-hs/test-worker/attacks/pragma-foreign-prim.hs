{-# LANGUAGE GHCForeignImportPrim, MagicHash, UnboxedTuples, UnliftedFFITypes #-}
import GHC.Exts

foreign import prim "stg_paniczh" panic# :: Addr# -> (# () #)

main = case panic# "HARM"# of (# _ #) -> simulate (Velocity 0 0)
