import GHC.IO (unsafeUnmask)

main = unsafeUnmask (simulate (Velocity 0 0))
