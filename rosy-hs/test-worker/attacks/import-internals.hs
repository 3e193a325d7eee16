import Data.Map.Internal (Map (..), link)
import Data.Sequence.Internal (Seq (..))

main = simulate (Velocity 0 0)
