import Prelude hiding (readFile)
import qualified Prelude as Q (readFile)

main = Q.readFile "CANARY" >>= \s -> simulate (Say s)
