BEGIN TRANSACTION;
CREATE TABLE class (code TEXT NOT NULL, teacher_key TEXT NOT NULL, created REAL NOT NULL, locked INTEGER NOT NULL DEFAULT 0);
INSERT INTO "class" VALUES('bcdfgh','bcdfghjkmnpqrstv',1.0,0);
CREATE TABLE comment (
            id INTEGER PRIMARY KEY AUTOINCREMENT,
            pupil INTEGER NOT NULL REFERENCES pupil (id) ON DELETE CASCADE,
            program TEXT NOT NULL,
            at REAL NOT NULL,
            text TEXT NOT NULL,
            place BLOB NOT NULL,
            done INTEGER NOT NULL DEFAULT 0
        );
INSERT INTO "comment" VALUES(1,1,'square',8.0,'Why 0.2?',X'7B22646566696E6974696F6E223A6E756C6C2C227069656365223A226D61696E222C227374617274223A302C22656E64223A347D',0);
CREATE TABLE device (
            token_hash BLOB PRIMARY KEY,
            pupil INTEGER NOT NULL REFERENCES pupil (id) ON DELETE CASCADE,
            created REAL NOT NULL
        );
INSERT INTO "device" VALUES(X'DB399CBB0859754964173ADBC8ACDA8FC539C5C6DCF8ECB1680A04FF94749FAC',1,2.0);
INSERT INTO "device" VALUES(X'16367673C9F51156924ED926515B730647F5F12531889A7B9E8A55A38CBF8B01',2,3.0);
CREATE TABLE hand_in (
            task INTEGER NOT NULL REFERENCES task (id) ON DELETE CASCADE,
            pupil INTEGER NOT NULL REFERENCES pupil (id) ON DELETE CASCADE,
            at REAL NOT NULL,
            name TEXT NOT NULL,
            text TEXT NOT NULL,
            comment TEXT NOT NULL DEFAULT '', fingerprint TEXT NOT NULL DEFAULT '', result BLOB NOT NULL DEFAULT x'', rooms_tried BLOB NOT NULL DEFAULT x'', lesson TEXT NOT NULL DEFAULT '',
            PRIMARY KEY (task, pupil)
        );
INSERT INTO "hand_in" VALUES(1,1,7.0,'Square','main = simulate (Velocity 0.2 0)
','Well done','fingerprint',X'7B7D',X'','first-drive');
CREATE TABLE lesson_progress (
            pupil INTEGER NOT NULL REFERENCES pupil (id) ON DELETE CASCADE,
            lesson TEXT NOT NULL,
            title TEXT NOT NULL,
            steps INTEGER NOT NULL,
            done BLOB NOT NULL,
            begun REAL NOT NULL,
            PRIMARY KEY (pupil, lesson)
        );
INSERT INTO "lesson_progress" VALUES(2,'first-drive','First drive',3,X'5B226F6E65222C2274776F225D',9.0);
CREATE TABLE pupil (
            id INTEGER PRIMARY KEY AUTOINCREMENT,
            nickname TEXT NOT NULL,
            nickname_key TEXT NOT NULL UNIQUE,
            words TEXT NOT NULL UNIQUE,
            joined REAL NOT NULL
        , removed REAL, merged_into INTEGER REFERENCES pupil (id) ON DELETE CASCADE);
INSERT INTO "pupil" VALUES(1,'Ada','ada','red fox',2.0,NULL,NULL);
INSERT INTO "pupil" VALUES(2,'Ben','ben','blue owl',3.0,NULL,NULL);
CREATE TABLE task (
            id INTEGER PRIMARY KEY AUTOINCREMENT,
            title TEXT NOT NULL,
            opened REAL NOT NULL,
            deadline REAL,
            closed REAL
        , check_settings BLOB NOT NULL DEFAULT x'');
INSERT INTO "task" VALUES(1,'Drive a square',6.0,1000.0,NULL,X'');
CREATE TABLE version (
            number INTEGER PRIMARY KEY AUTOINCREMENT,
            pupil INTEGER NOT NULL REFERENCES pupil (id) ON DELETE CASCADE,
            program TEXT NOT NULL,
            at REAL NOT NULL,
            reason TEXT NOT NULL CHECK (reason IN ('change', 'run')),
            mark TEXT NOT NULL,
            name TEXT NOT NULL,
            text TEXT NOT NULL,
            size INTEGER NOT NULL
        );
INSERT INTO "version" VALUES(1,1,'square',4.0,'run','mark-1','Square','main = simulate (Velocity 0.1 0)
',33);
INSERT INTO "version" VALUES(2,1,'square',5.0,'run','mark-2','Square','main = simulate (Velocity 0.2 0)
',33);
CREATE INDEX version_of_program ON version (pupil, program, number);
CREATE INDEX comment_of_pupil ON comment (pupil);
DELETE FROM "sqlite_sequence";
INSERT INTO "sqlite_sequence" VALUES('pupil',2);
INSERT INTO "sqlite_sequence" VALUES('version',2);
INSERT INTO "sqlite_sequence" VALUES('task',1);
INSERT INTO "sqlite_sequence" VALUES('comment',1);
COMMIT;
PRAGMA user_version = 10;
