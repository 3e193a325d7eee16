{-# LANGUAGE StaticPointers #-}
import GHC.StaticPtr

main = staticPtrKeys >>= \ks -> simulate (Say (show ks))
