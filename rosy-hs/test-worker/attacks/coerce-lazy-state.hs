import Control.Monad.ST.Lazy.Unsafe (unsafeInterleaveST)

main = simulate (Say "ran")
