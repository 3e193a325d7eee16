import qualified Data.Text.IO as T

main = T.readFile "CANARY" >>= \t -> simulate (Say (show t))
