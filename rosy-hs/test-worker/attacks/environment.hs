import System.Environment

main = getEnvironment >>= \e -> simulate (Say (concatMap (\(k, v) -> k ++ v) e))
