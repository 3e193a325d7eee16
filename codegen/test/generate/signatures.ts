/// Types that definitions of generated programs are given.

import type {Dice} from "./random.ts"

const sensors =
  `Bumper|Cliff|Wheel|Button|BumperLeft|CliffCenter|WheelRight|ButtonOne|RobotStatus|Velocity|Position|Orientation|Pose|Clock|Memory Bool|Memory Int|Param Double|Seconds|StdGen|Memory (Maybe Int)|(Clock, Memory Int)|Either Bumper Wheel|(Velocity, Bumper)|(Bumper, Memory Int)|Maybe Velocity|Bool|()`.split(
    "|",
  )

const commands =
  `Velocity|Led1|Led2|Sound|Maybe Sound|(Led1, Led2)|Either Velocity Sound|Memory Bool|Memory Int|[Say]|Say|Param Double|Maybe Velocity|(Velocity, Maybe Led1)|Either Velocity (Memory Int)|Memory (Maybe Int)|Never|()|Call|Call|Call|Call|Maybe Call|Feedback Int|Maybe (Feedback Double)|(Velocity, Feedback Bool)|Cancel|Maybe Cancel|Maybe Cancel`.split(
    "|",
  )

const plain =
  `Double|Int|Bool|String|[Int]|[Double]|Maybe Double|Task ()|Double -> Double|Task Bool|(Int, String)|Either Int String|[Task ()]|Char|Ordering|CallOptions Never () () Bool ()|TaskOptions Velocity ()|Task (Maybe Int)`.split(
    "|",
  )

/// Types with variables, as a learner who knows classes writes them.
const general: readonly {readonly text: string; readonly arity: number}[] = [
  {text: "a -> a", arity: 1},
  {text: "a -> b -> a", arity: 2},
  {text: "Num a => a -> a", arity: 1},
  {text: "Fractional a => a -> a -> a", arity: 2},
  {text: "Ord a => a -> a -> Bool", arity: 2},
  {text: "Eq a => a -> [a] -> Bool", arity: 2},
  {text: "Show a => a -> String", arity: 1},
  {text: "(Ord a, Show a) => [a] -> Maybe a", arity: 1},
  {text: "(a -> b) -> Maybe a -> Maybe b", arity: 2},
  {text: "Maybe a -> a -> a", arity: 2},
  {text: "[a] -> Int", arity: 1},
  {text: "Integral a => a -> a", arity: 1},
  {text: "(Random a, RandomGen g) => (a, a) -> g -> a", arity: 2},
  {text: "Default a => a -> Memory a", arity: 1},
  {text: "Monad m => m a -> m (a, a)", arity: 1},
  {text: "(Command a, Typeable b) => a -> b -> Task ()", arity: 2},
  {text: "Foldable t => t a -> Int", arity: 1},
]

export function signatureFor(
  dice: Dice,
  own: readonly string[],
): {readonly text: string; readonly arity: number} {
  if (dice.once(9)) return dice.pick(general)
  if (dice.once(4)) {
    const result = dice.pick([
      "()",
      "()",
      "Double",
      "Bool",
      "Maybe Bumper",
      "(Double, Bool)",
      "Either Bool Int",
      ...own,
    ])
    const input = dice.pick(["Double", "Int", "String", "Task ()", ...own])
    const task = `Task ${/^[^(].* /.test(result) ? `(${result})` : result}`
    return dice.once(2) ? {text: task, arity: 0} : {text: `${input} -> ${task}`, arity: 1}
  }
  const reaction = !dice.once(3)
  const count = reaction ? 1 + dice.below(dice.once(4) ? 4 : 2) : dice.below(dice.once(4) ? 5 : 3)
  const inputs = Array.from({length: count}, () =>
    dice.pick(reaction ? [...sensors, ...own] : [...plain, ...own, ...sensors.slice(0, 4)]),
  )
  const result = dice.pick(dice.once(3) ? [...plain, ...own] : [...commands, ...own])
  const bracket = (t: string) => (t.includes("->") ? `(${t})` : t)
  return {text: [...inputs.map(bracket), result].join(" -> "), arity: inputs.length}
}
