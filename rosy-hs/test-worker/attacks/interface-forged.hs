import Rosy
import qualified Rosy as Forged

instance Forged.Controller Int

instance Forged.Sensor Int

instance Forged.Command Int

main = simulate (1 :: Int)
