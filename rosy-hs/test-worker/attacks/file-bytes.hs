import qualified Data.ByteString as B

main = B.readFile "CANARY" >>= \b -> simulate (Say (show b))
