package org.dfra.cli.doctor;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.rmi.AccessException;
import java.rmi.ConnectException;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.OptionalLong;
import org.dfra.cli.doctor.Finding.Verdict;
import org.dfra.river.bootstrap.NoAnswerException;
import org.dfra.river.phoenix.GroupStatus;
import org.dfra.river.phoenix.GroupStatus.State;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is found of phoenix, its groups and its state folder. */
class RobotChecksTest {

  private static final long GIGABYTE = 1L << 30;

  @TempDir Path folder;

  /** A phoenix that answers, or not. */
  private record Fake(OptionalLong pid, @Nullable List<GroupStatus> answer, RemoteException failure)
      implements PhoenixCheck.Daemon {

    Fake(OptionalLong pid, @Nullable List<GroupStatus> answer) {
      this(pid, answer, new ConnectException("connection refused; nested exception is: …"));
    }

    @Override
    public String address() {
      return "192.0.2.10:1198";
    }

    @Override
    public List<GroupStatus> groups() throws RemoteException {
      if (answer == null) {
        throw failure;
      }
      return answer;
    }

    @Override
    public String log() {
      return "/state/phoenix.log";
    }
  }

  @Test
  void aPhoenixThatAnswersIsReported() {
    assertThat(new PhoenixCheck(new Fake(OptionalLong.of(17), List.of())).run())
        .containsExactly(Finding.ok(Subject.PHOENIX, "process 17 answers at 192.0.2.10:1198"));
    assertThat(new PhoenixCheck(new Fake(OptionalLong.empty(), List.of())).run())
        .containsExactly(
            Finding.ok(Subject.PHOENIX, "another user's process answers at 192.0.2.10:1198"));
  }

  @Test
  void noPhoenixIsAWarningAndASilentOneAFailure() {
    assertThat(new PhoenixCheck(new Fake(OptionalLong.empty(), null)).run())
        .singleElement()
        .returns(Verdict.WARN, Finding::verdict)
        .returns(
            "none answers at 192.0.2.10:1198, so nothing is brought up or back on this host",
            Finding::what);
    assertThat(new PhoenixCheck(new Fake(OptionalLong.of(17), null)).run())
        .singleElement()
        .returns(Verdict.FAIL, Finding::verdict)
        .returns(
            "process 17 does not answer at 192.0.2.10:1198 (connection refused)", Finding::what)
        .satisfies(finding -> assertThat(finding.remedy()).contains("/state/phoenix.log"));
  }

  @Test
  void oneThatMayBeThereAndDoesNotAnswerIsNotTakenForNone() {
    RemoteException silent =
        new NoAnswerException(
            "phoenix",
            Duration.ofSeconds(2),
            new ConnectException("no connection to 192.0.2.10:1198; nested exception is: …"));
    assertThat(new PhoenixCheck(new Fake(OptionalLong.empty(), null, silent)).run())
        .singleElement()
        .returns(Verdict.FAIL, Finding::verdict)
        .returns(
            "it is not known whether one runs at 192.0.2.10:1198, since it does not answer (no"
                + " connection to 192.0.2.10:1198)",
            Finding::what);
    assertThat(new PhoenixCheck(new Fake(OptionalLong.of(17), null, silent)).run())
        .singleElement()
        .returns(
            "process 17 does not answer at 192.0.2.10:1198 (no connection to 192.0.2.10:1198)",
            Finding::what);
  }

  @Test
  void aGroupThatIsHeldOffIsAFailure() {
    Instant until = Instant.parse("2026-11-21T07:43:44Z");
    List<GroupStatus> groups =
        List.of(
            group("1-r.lookup", 21, 0, null, null),
            group("2-r.gps", -1, 1, "it ended (exit code 137)", null),
            group("3-r.laser", -1, 5, "it ended (exit code 1)", until),
            group("4-r.idle", -1, 0, null, null));
    assertThat(new PhoenixCheck(new Fake(OptionalLong.of(17), groups)).run())
        .filteredOn(finding -> finding.subject() == Subject.GROUP)
        .extracting(Finding::verdict, Finding::what)
        .containsExactly(
            org.assertj.core.groups.Tuple.tuple(Verdict.OK, "group r.lookup is process 21"),
            org.assertj.core.groups.Tuple.tuple(
                Verdict.WARN, "group r.gps crashed lately: it ended (exit code 137)"),
            org.assertj.core.groups.Tuple.tuple(
                Verdict.FAIL,
                "group r.laser crashed too often and is held off until 2026-11-21T07:43:44Z (it"
                    + " ended (exit code 1))"),
            org.assertj.core.groups.Tuple.tuple(Verdict.OK, "group r.idle waits for a call"));
  }

  @Test
  void aProcessWithSomethingThatPhoenixHasForgottenIsAWarning() {
    GroupStatus left =
        new GroupStatus(
            "1-r.wheels", State.ACTIVE, 1, 21, false, 0, 2, 0, 0, null, null, "/state/wheels.log");
    assertThat(new PhoenixCheck(new Fake(OptionalLong.of(17), List.of(left))).run().get(1))
        .isEqualTo(
            Finding.warn(
                Subject.GROUP,
                "group r.wheels is process 21 and still has 2 services that phoenix has forgotten,"
                    + " as an interrupted ./dfra down leaves it",
                "End the process: ./dfra down r, or ./dfra up with the robot's XML."));
  }

  private static GroupStatus group(
      String name, long pid, int crashes, @Nullable String lastCrash, @Nullable Instant until) {
    return new GroupStatus(
        name,
        pid < 0 ? State.IDLE : State.ACTIVE,
        1,
        pid,
        false,
        1,
        0,
        crashes,
        crashes,
        lastCrash,
        until,
        "/state/output/" + name + ".log");
  }

  @Test
  void aStateFolderIsThereOrCanBeMade() throws Exception {
    assertThat(state(folder, GIGABYTE))
        .containsExactly(
            Finding.ok(Subject.STATE_FOLDER, folder + " can be written"),
            Finding.ok(Subject.DISK_SPACE, "there is room for 1024 MB in " + folder));
    Path missing = folder.resolve("not/yet");
    assertThat(state(missing, 20 * GIGABYTE))
        .containsExactly(
            Finding.ok(Subject.STATE_FOLDER, missing + " is not there yet and can be made"),
            Finding.ok(Subject.DISK_SPACE, "there is room for 20 GB in " + missing));
    Files.createDirectory(folder.resolve("journal"));
    Files.write(folder.resolve("journal/Snapshot.1"), new byte[2048]);
    assertThat(state(folder, GIGABYTE))
        .contains(Finding.ok(Subject.JOURNAL, folder.resolve("journal") + " has 2 KB"));
  }

  @Test
  void aFolderThatOthersMayEnterIsAFailureWithTheCommandThatMendsIt() throws Exception {
    Path open = Files.createDirectory(folder.resolve("open"));
    Files.setPosixFilePermissions(open, PosixFilePermissions.fromString("rwxr-xr-x"));
    assertThat(state(open, GIGABYTE).get(0))
        .returns(Verdict.FAIL, Finding::verdict)
        .returns(
            "other users may enter the folder "
                + open
                + " (rwxr-xr-x), which must be private; type: chmod 700 "
                + open,
            Finding::what);
  }

  @Test
  void aPhoenixOfAnotherUserIsAWarningThatSaysWhose() {
    PhoenixCheck.Daemon foreign =
        new PhoenixCheck.Daemon() {
          @Override
          public String address() {
            return "192.0.2.10:1198";
          }

          @Override
          public OptionalLong pid() {
            return OptionalLong.empty();
          }

          @Override
          public List<GroupStatus> groups() throws RemoteException {
            throw new AccessException("the phoenix on port 1198 belongs to user a; …");
          }

          @Override
          public String log() {
            return "/state/phoenix.log";
          }
        };
    assertThat(new PhoenixCheck(foreign).run())
        .singleElement()
        .returns(Verdict.WARN, Finding::verdict)
        .returns("the phoenix on port 1198 belongs to user a; …", Finding::what);
  }

  @Test
  void aFolderThatCannotBeWrittenIsAFailure() throws Exception {
    Path file = Files.createFile(folder.resolve("file"));
    assertThat(state(file.resolve("state"), GIGABYTE).get(0))
        .returns(Verdict.FAIL, Finding::verdict)
        .returns(file + " is not a folder", Finding::what);
    Path closed =
        Files.createDirectory(
            folder.resolve("closed"),
            PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("r-xr-xr-x")));
    Assumptions.assumeFalse(Files.isWritable(closed), "this user may write everywhere");
    assertThat(state(closed, GIGABYTE).get(0).verdict()).isEqualTo(Verdict.FAIL);
  }

  @Test
  void littleRoomIsAWarningAndNoneAFailure() {
    assertThat(state(folder, 50L << 20).get(1))
        .returns(Verdict.WARN, Finding::verdict)
        .returns("there is room for 50 MB in " + folder, Finding::what);
    assertThat(state(folder, 4096).get(1))
        .returns(Verdict.FAIL, Finding::verdict)
        .returns("there is room for 4 KB in " + folder, Finding::what);
  }

  private static List<Finding> state(Path state, long freeBytes) {
    return new StateCheck(state, path -> freeBytes).run();
  }
}
