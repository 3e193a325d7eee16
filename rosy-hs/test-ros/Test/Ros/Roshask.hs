-- |
-- Description : roshask's own examples, unchanged: they compile with this library and run among rospy nodes.
--
-- Two of the nine programs use the package vector-space. Where that cannot be had, the test says so and takes the other seven.
module Test.Ros.Roshask (tests) where

import Control.Monad (unless, void)
import Data.List (intercalate, isInfixOf)
import Data.Maybe (isJust)
import System.Directory (getTemporaryDirectory, removeDirectoryRecursive)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.Posix.Temp (mkdtemp)
import System.Process
import Test.Ros.Peer
import Test.Tasty
import Test.Tasty.HUnit

tests :: TestTree
tests = withResource compile (removeDirectoryRecursive . folder) $ \compiled ->
  testGroup
    "roshask's own examples"
    [ testCaseInfo "compile unchanged" (report <$> compiled),
      localOption (mkTimeout 900000000) . testCaseInfo "run among rospy nodes" $ do
        examples <- compiled
        ready <- withRos (folder examples)
        case ready of
          Left why -> pure ("skipped: " ++ why)
          Right modules -> report examples <$ withMaster modules (playAll examples)
    ]

-- | Where the programs are, and why the two that compute angles are missing.
data Compiled = Compiled {folder :: FilePath, withoutAngles :: Maybe String}

report :: Compiled -> String
report = maybe "all nine" ("seven of nine: " ++) . withoutAngles

original :: FilePath -> FilePath
original file = "rosy-hs/test-ros/roshask" </> file

-- | One program for those that are modules, told by its first argument which of them to be, and two that are called Main themselves.
compile :: IO Compiled
compile = do
  (code, out, err) <- readProcessWithExitCode "rosy-hs/test-ros/setup-roshask" [] ""
  let missing = if code == ExitSuccess then Nothing else Just (unwords (lines (out ++ err)))
  made <- getTemporaryDirectory >>= \tmp -> mkdtemp (tmp </> "roshask-")
  writeFile (made </> "Chosen.hs") (chosen (modules ++ maybe ["Turtle2", "Turtle3"] (const []) missing))
  let with = ["vector-space" | Nothing <- [missing]]
  ghc with made "chosen" (made </> "Chosen.hs")
  ghc with made "compose" (original "NodeCompose/src/Main.hs")
  ghc with made "add" (original "AddTwoIntsClient/src/Main.hs")
  pure (Compiled made missing)
  where
    modules = ["Talker", "Listener", "Telescope", "DetectUFO", "Turtle"]

chosen :: [String] -> String
chosen names =
  unlines $
    ["module Main (main) where", "", "import System.Environment (getArgs)"]
      ++ ["import qualified " ++ name | name <- names]
      ++ ["", "main :: IO ()", "main = getArgs >>= \\arguments -> case head arguments of"]
      ++ ["  " ++ show name ++ " -> () <$ " ++ name ++ ".main" | name <- names]
      ++ ["  other -> fail other"]

-- | With the library that cabal has built for this test, and the packages that the examples' own cabal files name.
ghc :: [String] -> FilePath -> String -> FilePath -> IO ()
ghc more made program file = do
  version <- filter (/= '\n') <$> readProcess "ghc" ["--numeric-version"] ""
  description <- readFile "rosy.cabal"
  let own = concat [v | l <- lines description, ["version:", v] <- [words l]]
      packages = concat [["-package", p] | p <- ["base", "mtl", "time", "vector"] ++ more]
      library = ["-package-db", "dist-newstyle/packagedb/ghc-" ++ version, "-package-id", "rosy-" ++ own ++ "-inplace-ros"]
      sources = intercalate ":" (map (original . (</> "src")) ["PubSub", "Turtle", "NodeCompose"])
  (code, out, err) <-
    readProcessWithExitCode "ghc" (["-v0", "-w", "-O0", "-dynamic", "-threaded", "-XHaskell2010", "-hide-all-packages"] ++ packages ++ library ++ ["-i" ++ sources, "-outputdir", made </> "objects", "-o", made </> program, file]) ""
  unless (code == ExitSuccess) $ assertFailure (file ++ " does not compile:\n" ++ unlines (take 40 (lines (out ++ err))))

-- | Starts one of the compiled programs with arguments.
type Start = forall a. String -> [String] -> (Peer -> IO a) -> IO a

playAll :: Compiled -> Ros -> IO ()
playAll examples ros = withPeer ros "peer" $ \peer -> do
  let start :: Start
      start program = withProgram ros (folder examples </> program)
  talk start peer
  watch start peer
  drive start peer "Turtle"
  awaitTranscript peer (any (isInfixOf "log /HaskellBTurtle 2"))
  logged <- transcript peer
  assertBool "what Turtle logs is on /rosout" (any ("Waiting for new traj" `isInfixOf`) logged)
  unless (isJust (withoutAngles examples)) $ do
    drive start peer "Turtle2"
    steer start peer "Turtle3"
  withProgram ros "sh" ["-c", (folder examples </> "add") ++ " 2>&1"] $ \p -> void (hears p "add: MasterExcept \"No node offers the service /add_two_ints.\"")
  add start peer

-- | Talker to Listener and to rospy, and rospy to Listener.
talk :: Start -> Peer -> IO ()
talk start peer = start "chosen" ["Listener"] $ \listener -> do
  mapM_ (say peer) ["rosout", "sub /chatter std_msgs/String", "pub /chatter std_msgs/String", "connected /chatter 2"]
  _ <- hears peer "connected"
  say peer "send /chatter {\"data\": \"from rospy\"}"
  _ <- hears listener "I heard from rospy"
  start "chosen" ["Talker"] $ \_ -> do
    _ <- hears listener "I heard Hello world 2"
    void (hears peer "got /chatter {\"data\": \"Hello world 2")

-- | Telescope to DetectUFO and to rospy, rospy to DetectUFO, and both of them in one process.
watch :: Start -> Peer -> IO ()
watch start peer = do
  start "chosen" ["DetectUFO", "video:=/pictures"] $ \detector -> do
    mapM_ (say peer) ["pub /pictures sensor_msgs/Image", "connected /pictures 1"]
    _ <- hears peer "connected"
    -- White is the point above and left of the middle.
    say peer "send /pictures {\"height\": 4, \"width\": 4, \"encoding\": \"mono8\", \"data\": [255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]}"
    _ <- hears detector "UFO at angle: -135.0"
    say peer "send /pictures {\"height\": 1, \"width\": 1, \"encoding\": \"mono8\", \"data\": [0]}"
    _ <- hears detector "Couldn't find UFO"
    say peer "send /pictures {\"encoding\": \"rgb8\"}"
    void (hears detector "Unsupported image format")
  start "chosen" ["DetectUFO"] $ \detector -> start "chosen" ["Telescope"] $ \_ -> do
    _ <- hears detector "UFO at angle: "
    mapM_ (say peer) ["sub /video sensor_msgs/Image quiet", "heard /video 1"]
    void (hears peer "heard /video")
  start "compose" [] $ \both -> void (hears both "UFO at angle: ")

-- | Four metres ahead is the first goal, and when it is reached the second one is behind to the right. Both turtles are as fast as they may be.
drive :: Start -> Peer -> String -> IO ()
drive start peer name = withTurtle start peer name $ do
  -- Again and again: the turtle may not have read its goals yet.
  say peer ("stream " ++ pose name ++ " {\"x\": 1, \"y\": 5}")
  _ <- hearsWhere peer "straight on" (turns name "z\": 0.0")
  say peer ("stream " ++ pose name ++ " {\"x\": 5, \"y\": 4.5}")
  void (hearsWhere peer "a turn to the right" (turns name "z\": -2.0"))

-- | The goal is to the right of where it looks, so the controller's signal is negative.
steer :: Start -> Peer -> String -> IO ()
steer start peer name = withTurtle start peer name $ do
  say peer ("stream " ++ pose name ++ " {\"x\": 1, \"y\": 5, \"theta\": 1}")
  void (hearsWhere peer "a turn to the right" (turns name "z\": -"))

-- | A turtle that has its goals, on topics of its own.
withTurtle :: Start -> Peer -> String -> IO () -> IO ()
withTurtle start peer name act = do
  mapM_ (say peer) ["pub " ++ pose name ++ " turtlesim/Pose", "sub " ++ velocity name ++ " geometry_msgs/Twist"]
  start "chosen" [name, "/turtle1/pose:=" ++ pose name, "/turtle1/cmd_vel:=" ++ velocity name] $ \turtle -> do
    say turtle "[(5,5),(1,1)]"
    mapM_ (say peer) ["connected " ++ pose name ++ " 1", "listening " ++ velocity name]
    _ <- hears peer "listening"
    act

pose, velocity :: String -> String
pose name = "/" ++ name ++ "/pose"
velocity name = "/" ++ name ++ "/cmd_vel"

-- | A command of this turtle at two metres per second that turns so.
turns :: String -> String -> String -> Bool
turns name turn line = all (`isInfixOf` line) ["got " ++ velocity name, "\"linear\": {\"x\": 2.0", "\"angular\": {\"x\": 0.0, \"y\": 0.0, \"" ++ turn]

add :: Start -> Peer -> IO ()
add start peer = do
  say peer "add /add_two_ints"
  _ <- hears peer "serving"
  start "add" [] $ \caller -> void (hears caller "AddTwoIntsResponse {_sum = 15}")
  void (hears peer "asked /add_two_ints 10 5")
