import qualified Prelude as P
import Prelude

main = P.readFile "CANARY" >>= \s -> simulate (Say s)
