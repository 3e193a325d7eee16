-- |
-- Description : .msg files in, sums and modules out.
module Test.Ros.Generator (tests) where

import Data.List (sort)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Ros.Gen.Files
import Ros.Gen.Haskell
import Ros.Gen.Md5
import Ros.Gen.Msg
import System.Directory (doesFileExist, listDirectory)
import System.FilePath ((</>))
import Test.Tasty
import Test.Tasty.HUnit
import Test.Tasty.QuickCheck

tests :: TestTree
tests =
  testGroup
    "generator"
    [ testGroup "sums equal the ones that ROS has for the same text" (map sumOf known),
      testCase "the modules in the repository are what the generator prints now" $ do
        definitions <- loaded
        names <- maybe [] Set.toList <$> compiledNames folder
        texts <- either assertFailure pure (modules (withoutServices Map.empty) definitions names)
        mapM_ upToDate texts
        -- What the listed ones nest is listed too: a user's modules are made without it.
        library' <- loadLibrary [folder] >>= either assertFailure pure
        Map.keysSet (definedMessages library') `Set.union` definedServices library' @?= Set.fromList (map fst texts)
        onDisk <- sort . concat <$> (listDirectory (generated </> "Ros") >>= mapM (\p -> map (("Ros" </> p) </>) <$> listDirectory (generated </> "Ros" </> p)))
        onDisk @?= sort (map (modulePath . fst) texts),
      testCase "a message that is not compiled is made alone, with what it nests and the library has not" $ do
        definitions <- loaded
        library' <- loadLibrary [folder] >>= either assertFailure pure
        let made = fmap (map (fullName . fst)) . modules library' definitions
        made ["sensor_msgs/Imu"] @?= Right ["sensor_msgs/Imu"]
        made ["sensor_msgs/PointCloud"] @?= Right ["geometry_msgs/Point32", "sensor_msgs/ChannelFloat32", "sensor_msgs/PointCloud"]
        made ["std_srvs/Empty"] @?= Right ["std_srvs/EmptyRequest", "std_srvs/EmptyResponse", "std_srvs/Empty"]
        made ["std_msgs/Nothing"] @?= Left "there is no message or service std_msgs/Nothing",
      testCase "a string constant keeps its number sign, a number its zeros, and comments go" $
        fmap (\m -> (constants m, fields m)) (readMsg led "string A=x # y\nuint64 B=007  # why\n\n# only words\nfloat32[] c # d\nOther[3] e\n")
          @?= Right
            ( [Constant TString "A" "x # y", Constant TUInt64 "B" "007"],
              [Field (Builtin TFloat32) Many "c", Field (Nested (MsgName "p" "Other")) (Exactly 3) "e"]
            ),
      testCase "a line that is neither field nor constant is named with its number" $
        readMsg led "uint8 a\nuint8\n" @?= Left (StrangeLine 2 "uint8"),
      testGroup
        "a constant is a value of its type, in the forms that Python reads"
        [ testCase text $ (either (const Nothing) Just (readMsg led (text ++ "\n")) >>= constantValue . head . constants) @?= value
          | (text, value) <-
              [ ("int8 A=-128", Just (Whole (-128))),
                ("int8 A=-129", Nothing),
                ("byte A=-1", Just (Whole (-1))),
                ("char A=-1", Nothing),
                ("uint8 A=256", Nothing),
                ("uint64 A=1_000", Just (Whole 1000)),
                ("uint64 A=1__0", Nothing),
                ("int32 A=0x10", Nothing),
                ("int32 A=", Nothing),
                ("bool A=True", Just (Truth True)),
                ("bool A=0", Just (Truth False)),
                ("bool A=maybe", Nothing),
                ("float32 A=-.5", Just (Decimal True "" "5" 0)),
                ("float64 A=1.E3", Just (Decimal False "1" "" 3)),
                ("float64 A=-Infinity", Just (Infinite True)),
                ("float64 A=nan", Just NotANumber),
                ("float64 A=.", Nothing),
                ("string A= a = b # c", Just (Text "a = b # c"))
              ]
        ],
      testCase "two fields of one name are refused" $
        readMsg led "uint8 a\nint8 a\n" @?= Left (DuplicateField "a"),
      testCase "an array of Header is of the package's own, one Header is that of std_msgs" $
        fmap (map fieldType . fields) (readMsg led "Header h\nHeader[] hs\n") @?= Right [Nested (MsgName "std_msgs" "Header"), Nested (MsgName "p" "Header")],
      testCase "a service is a request and a response, on both sides of the first border; its sum is of both texts" $ do
        let name = MsgName "std_srvs" "SetBool"
            summed text = do
              (request, response) <- either (Left . explainMsgError) Right (readSrv name text)
              either (Left . explainNestingError) Right (serviceMd5 (messages [request, response]) request response)
        fmap (\(a, b) -> (msgName a, map fieldName (fields a), msgName b, map fieldName (fields b))) (readSrv name "bool data # in\n--- out\nbool success\nstring message\n")
          @?= Right (MsgName "std_srvs" "SetBoolRequest", ["data"], MsgName "std_srvs" "SetBoolResponse", ["success", "message"])
        summed "bool data # e.g. for hardware enabling / disabling\n---\nbool success   # indicate successful run of triggered service\nstring message # informational, e.g. for error messages\n" @?= Right "09fb03525b03e7ea1fd3992bafd87e16"
        summed "---" @?= Right "d41d8cd98f00b204e9800998ecf8427e"
        summed "bool data\nwhat\n---\n" @?= Left "line 2 is neither a field nor a constant: what",
      testCase "a service that is called like a message is refused" $ do
        let both = Definitions (messages [m | Right m <- [readMsg led "", readMsg (MsgName "p" "LedRequest") "", readMsg (MsgName "p" "LedResponse") ""]]) (Set.singleton led)
        fmap (map fst) (modules (withoutServices Map.empty) both ["p"]) @?= Left "p/Led is the name of a message and of a service; their modules would have one name",
      testCase "what is nested is made too, except what the library has" $
        fmap (map fst) (library "int8 x\n") @?= Right [led, MsgName "q" "Other"],
      testCase "a message that the library has with other fields is refused" $
        fmap (map fst) (library "int16 x\n") @?= Left "q/Ours is in the library already, with other fields or constants; only one of them can be used in a program",
      testCase "a constant of a time is refused" $
        readMsg led "time NOW=3\n" @?= Left (StrangeConstant 1 "time NOW=3"),
      testCase "a nested message that was not given is named" $
        (readEither "Other o\n" >>= \m -> either (Right . Just) (const (Right Nothing)) (md5 (messages [m]) m))
          @?= Right (Just (MissingMessage led (MsgName "p" "Other"))),
      testGroup
        "a message that nests itself is refused, with the way around"
        [ testCase (show names) $ (cyclic >>= \known' -> maybe (Left "no such message") Right (Map.lookup (MsgName "p" start) known') >>= \m -> pure (md5 known' m, fullDefinition known' m)) @?= Right (Left cycle', Left cycle')
          | (start, names) <- [("Self", ["Self", "Self"]), ("A", ["A", "B", "A"]), ("Outer", ["A", "B", "A"])],
            let cycle' = CyclicMessage (map (MsgName "p") names)
        ],
      testCase "a message that nests another one twice is no cycle, and the others stay" $
        fmap (map (base . msgName) . Map.elems . withoutCycles) cyclic @?= Right ["Leaf", "Twice"],
      testProperty "any text is read or refused, and what is read can be printed" $ \text ->
        case readMsg led text of
          Left e -> property (not (null (explainMsgError e)))
          Right m -> property (not (null (haskellModule Nothing "" "" m)))
    ]
  where
    cyclic = messages <$> traverse (\(name, text) -> either (Left . explainMsgError) Right (readMsg (MsgName "p" name) text)) [("Self", "int8 x\nSelf[] more\n"), ("A", "B b\n"), ("B", "A[2] a\n"), ("Outer", "Leaf l\nA a\n"), ("Leaf", "int8 x\n"), ("Twice", "Leaf a\nLeaf b\n")]
    led = MsgName "p" "Led"
    library text = do
      ours <- parsed (MsgName "q" "Ours") "int8 x\n"
      known' <- sequence [parsed led "q/Ours a\nq/Other b\n", parsed (MsgName "q" "Other") "", parsed (MsgName "q" "Ours") text, parsed (MsgName "q" "Unused") ""]
      modules (withoutServices (messages [ours])) (withoutServices (messages known')) ["p"]
    parsed name = either (Left . explainMsgError) Right . readMsg name
    readEither t = either (Left . explainMsgError) Right (readMsg led t)

folder, generated :: FilePath
folder = "rosy-hs/ros/msg"
generated = "rosy-hs/ros/generated"

loaded :: IO Definitions
loaded = loadDefinitions [folder] >>= either assertFailure pure

upToDate :: (MsgName, String) -> Assertion
upToDate (name, text) = do
  let path = generated </> modulePath name
  exists <- doesFileExist path
  assertBool (path ++ " is missing; run rosy-messages") exists
  there <- readFile path
  assertBool (path ++ " is old; run rosy-messages") (there == text)

sumOf :: (String, String) -> TestTree
sumOf (name, expected) = testCase name $ do
  ms <- definedMessages <$> loaded
  n <- either (assertFailure . explainMsgError) pure (readMsgName name)
  m <- maybe (assertFailure "no such message") pure (Map.lookup n ms)
  md5 ms m @?= Right expected

-- | Computed by genpy from the upstream packages (kobuki_msgs, common_msgs 1.13.1, std_msgs 0.5.13,
-- rosgraph_msgs 1.11.3).
known :: [(String, String)]
known =
  [ ("actionlib_msgs/GoalID", "302881f31927c1df708a2dbab0e80ee8"),
    ("actionlib_msgs/GoalStatus", "d388f9b87b3c471f784434d671988d4a"),
    ("actionlib_msgs/GoalStatusArray", "8b2b82f13216d0a8ea88bd3af735e619"),
    ("geometry_msgs/Accel", "9f195f881246fdfa2798d1d3eebca84a"),
    ("geometry_msgs/AccelStamped", "d8a98a5d81351b6eb0578c78557e7659"),
    ("geometry_msgs/AccelWithCovariance", "ad5a718d699c6be72a02b8d6a139f334"),
    ("geometry_msgs/AccelWithCovarianceStamped", "96adb295225031ec8d57fb4251b0a886"),
    ("geometry_msgs/Inertia", "1d26e4bb6c83ff141c5cf0d883c2b0fe"),
    ("geometry_msgs/InertiaStamped", "ddee48caeab5a966c5e8d166654a9ac7"),
    ("geometry_msgs/Point", "4a842b65f413084dc2b10fb484ea7f17"),
    ("geometry_msgs/Point32", "cc153912f1453b708d221682bc23d9ac"),
    ("geometry_msgs/PointStamped", "c63aecb41bfdfd6b7e1fac37c7cbe7bf"),
    ("geometry_msgs/Polygon", "cd60a26494a087f577976f0329fa120e"),
    ("geometry_msgs/PolygonStamped", "c6be8f7dc3bee7fe9e8d296070f53340"),
    ("geometry_msgs/Pose", "e45d45a5a1ce597b249e23fb30fc871f"),
    ("geometry_msgs/Pose2D", "938fa65709584ad8e77d238529be13b8"),
    ("geometry_msgs/PoseArray", "916c28c5764443f268b296bb671b9d97"),
    ("geometry_msgs/PoseStamped", "d3812c3cbc69362b77dc0b19b345f8f5"),
    ("geometry_msgs/PoseWithCovariance", "c23e848cf1b7533a8d7c259073a97e6f"),
    ("geometry_msgs/PoseWithCovarianceStamped", "953b798c0f514ff060a53a3498ce6246"),
    ("geometry_msgs/Quaternion", "a779879fadf0160734f906b8c19c7004"),
    ("geometry_msgs/QuaternionStamped", "e57f1e547e0e1fd13504588ffc8334e2"),
    ("geometry_msgs/Transform", "ac9eff44abf714214112b05d54a3cf9b"),
    ("geometry_msgs/TransformStamped", "b5764a33bfeb3588febc2682852579b0"),
    ("geometry_msgs/Twist", "9f195f881246fdfa2798d1d3eebca84a"),
    ("geometry_msgs/TwistStamped", "98d34b0043a2093cf9d9345ab6eef12e"),
    ("geometry_msgs/TwistWithCovariance", "1fe8a28e6890a4cc3ae4c3ca5c7d82e6"),
    ("geometry_msgs/TwistWithCovarianceStamped", "8927a1a12fb2607ceea095b2dc440a96"),
    ("geometry_msgs/Vector3", "4a842b65f413084dc2b10fb484ea7f17"),
    ("geometry_msgs/Vector3Stamped", "7b324c7325e683bf02a9b14b01090ec7"),
    ("geometry_msgs/Wrench", "4f539cf138b23283b520fd271b567936"),
    ("geometry_msgs/WrenchStamped", "d78d3cb249ce23087ade7e7d0c40cfa7"),
    ("kobuki_msgs/BumperEvent", "ffe360cd50f14f9251d9844083e72ac5"),
    ("kobuki_msgs/ButtonEvent", "49eca512765dbdec759a79083ffcec8d"),
    ("kobuki_msgs/CliffEvent", "c5b106efbb1427a94f517c5e05f06295"),
    ("kobuki_msgs/ControllerInfo", "46af38e72f0640f41ed22174d43a2550"),
    ("kobuki_msgs/DigitalInputEvent", "93da823c8b121f8a3940ef3830c58e44"),
    ("kobuki_msgs/DigitalOutput", "1e97cd7f196a0270516b506e8bf29ca2"),
    ("kobuki_msgs/DockInfraRed", "a3d77f7d15e50579473dcc24e9b97b34"),
    ("kobuki_msgs/ExternalPower", "95149d524971a4c6d19e64c827307194"),
    ("kobuki_msgs/KeyboardInput", "9288b95cb32b48719d84d696be253401"),
    ("kobuki_msgs/Led", "4391183b0cf05f8f25d04220401b9f43"),
    ("kobuki_msgs/MotorPower", "8f77c0161e0f2021493136bb5f3f0e51"),
    ("kobuki_msgs/PowerSystemEvent", "f6464657d6c911b00c7bc7b43a154bf8"),
    ("kobuki_msgs/RobotStateEvent", "c6eccd4cb1f95df95635b56d6226ea32"),
    ("kobuki_msgs/ScanAngle", "06e2c839dc5c7f5c13ac09a8b4ff0a6a"),
    ("kobuki_msgs/SensorState", "430a4bfd78449c8740bfef32b26613a6"),
    ("kobuki_msgs/Sound", "dfeab0daae67749c426c1db741a4f420"),
    ("kobuki_msgs/VersionInfo", "3dc0ce6edd49be1fc86730f4a4a21861"),
    ("kobuki_msgs/WheelDropEvent", "e102837d89384d67669a0df86b63f33b"),
    ("nav_msgs/GridCells", "b9e4f5df6d28e272ebde00a3994830f5"),
    ("nav_msgs/MapMetaData", "10cfc8a2818024d3248802c00c95f11b"),
    ("nav_msgs/OccupancyGrid", "3381f2d731d4076ec5c71b0759edbe4e"),
    ("nav_msgs/Odometry", "cd5e73d190d741a2f92e81eda573aca7"),
    ("nav_msgs/Path", "6227e2b7e9cce15051f669a5e197bbf7"),
    ("rosgraph_msgs/Clock", "a9c97c1d230cfc112e270351a944ee47"),
    ("rosgraph_msgs/Log", "acffd30cd6b6de30f120938c17c593fb"),
    ("rosgraph_msgs/TopicStatistics", "10152ed868c5097a5e2e4a89d7daa710"),
    ("sensor_msgs/BatteryState", "4ddae7f048e32fda22cac764685e3974"),
    ("sensor_msgs/CameraInfo", "c9a58c1b0b154e0e6da7578cb991d214"),
    ("sensor_msgs/ChannelFloat32", "3d40139cdd33dfedcb71ffeeeb42ae7f"),
    ("sensor_msgs/CompressedImage", "8f7a12909da2c9d3332d540a0977563f"),
    ("sensor_msgs/FluidPressure", "804dc5cea1c5306d6a2eb80b9833befe"),
    ("sensor_msgs/Illuminance", "8cf5febb0952fca9d650c3d11a81a188"),
    ("sensor_msgs/Image", "060021388200f6f0f447d0fcd9c64743"),
    ("sensor_msgs/Imu", "6a62c6daae103f4ff57a132d6f95cec2"),
    ("sensor_msgs/JointState", "3066dcd76a6cfaef579bd0f34173e9fd"),
    ("sensor_msgs/Joy", "5a9ea5f83505693b71e785041e67a8bb"),
    ("sensor_msgs/JoyFeedback", "f4dcd73460360d98f36e55ee7f2e46f1"),
    ("sensor_msgs/JoyFeedbackArray", "cde5730a895b1fc4dee6f91b754b213d"),
    ("sensor_msgs/LaserEcho", "8bc5ae449b200fba4d552b4225586696"),
    ("sensor_msgs/LaserScan", "90c7ef2dc6895d81024acba2ac42f369"),
    ("sensor_msgs/MagneticField", "2f3b0b43eed0c9501de0fa3ff89a45aa"),
    ("sensor_msgs/MultiDOFJointState", "690f272f0640d2631c305eeb8301e59d"),
    ("sensor_msgs/MultiEchoLaserScan", "6fefb0c6da89d7c8abe4b339f5c2f8fb"),
    ("sensor_msgs/NavSatFix", "2d3a8cd499b9b4a0249fb98fd05cfa48"),
    ("sensor_msgs/NavSatStatus", "331cdbddfa4bc96ffc3b9ad98900a54c"),
    ("sensor_msgs/PointCloud", "d8e9c3f5afbdd8a130fd1d2763945fca"),
    ("sensor_msgs/PointCloud2", "1158d486dd51d683ce2f1be655c3c181"),
    ("sensor_msgs/PointField", "268eacb2962780ceac86cbd17e328150"),
    ("sensor_msgs/Range", "c005c34273dc426c67a020a87bc24148"),
    ("sensor_msgs/RegionOfInterest", "bdb633039d588fcccb441a4d43ccfe09"),
    ("sensor_msgs/RelativeHumidity", "8730015b05955b7e992ce29a2678d90f"),
    ("sensor_msgs/Temperature", "ff71b307acdbe7c871a5a6d7ed359100"),
    ("sensor_msgs/TimeReference", "fded64a0265108ba86c3d38fb11c0c16"),
    ("std_msgs/Bool", "8b94c1b53db61fb6aed406028ad6332a"),
    ("std_msgs/Byte", "ad736a2e8818154c487bb80fe42ce43b"),
    ("std_msgs/ByteMultiArray", "70ea476cbcfd65ac2f68f3cda1e891fe"),
    ("std_msgs/Char", "1bf77f25acecdedba0e224b162199717"),
    ("std_msgs/ColorRGBA", "a29a96539573343b1310c73607334b00"),
    ("std_msgs/Duration", "3e286caf4241d664e55f3ad380e2ae46"),
    ("std_msgs/Empty", "d41d8cd98f00b204e9800998ecf8427e"),
    ("std_msgs/Float32", "73fcbf46b49191e672908e50842a83d4"),
    ("std_msgs/Float32MultiArray", "6a40e0ffa6a17a503ac3f8616991b1f6"),
    ("std_msgs/Float64", "fdb28210bfa9d7c91146260178d9a584"),
    ("std_msgs/Float64MultiArray", "4b7d974086d4060e7db4613a7e6c3ba4"),
    ("std_msgs/Header", "2176decaecbce78abc3b96ef049fabed"),
    ("std_msgs/Int16", "8524586e34fbd7cb1c08c5f5f1ca0e57"),
    ("std_msgs/Int16MultiArray", "d9338d7f523fcb692fae9d0a0e9f067c"),
    ("std_msgs/Int32", "da5909fbe378aeaf85e547e830cc1bb7"),
    ("std_msgs/Int32MultiArray", "1d99f79f8b325b44fee908053e9c945b"),
    ("std_msgs/Int64", "34add168574510e6e17f5d23ecc077ef"),
    ("std_msgs/Int64MultiArray", "54865aa6c65be0448113a2afc6a49270"),
    ("std_msgs/Int8", "27ffa0c9c4b8fb8492252bcad9e5c57b"),
    ("std_msgs/Int8MultiArray", "d7c1af35a1b4781bbe79e03dd94b7c13"),
    ("std_msgs/MultiArrayDimension", "4cd0c83a8683deae40ecdac60e53bfa8"),
    ("std_msgs/MultiArrayLayout", "0fed2a11c13e11c5571b4e2a995a91a3"),
    ("std_msgs/String", "992ce8a1687cec8c8bd883ec73ca41d1"),
    ("std_msgs/Time", "cd7166c74c552c311fbcc2fe5a7bc289"),
    ("std_msgs/UInt16", "1df79edf208b629fe6b81923a544552d"),
    ("std_msgs/UInt16MultiArray", "52f264f1c973c4b73790d384c6cb4484"),
    ("std_msgs/UInt32", "304a39449588c7f8ce2df6e8001c5fce"),
    ("std_msgs/UInt32MultiArray", "4d6a180abc9be191b96a7eda6c8a233d"),
    ("std_msgs/UInt64", "1b2a79973e8bf53d7b53acb71299cb57"),
    ("std_msgs/UInt64MultiArray", "6088f127afb1d6c72927aa1247e945af"),
    ("std_msgs/UInt8", "7c8164229e7d2c17eb95e9231617fdee"),
    ("std_msgs/UInt8MultiArray", "82373f1612381bb6ee473b5cd6f5d89c")
  ]
