package org.dfra.cli.doctor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.lang.reflect.Proxy;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.Callable;
import net.jini.admin.Administrable;
import org.dfra.cli.doctor.ClockCheck.NtpClockOffset;
import org.dfra.cli.doctor.ClockCheck.RobotClock;
import org.dfra.cli.doctor.Finding.Verdict;
import org.dfra.cli.doctor.RegistrarCheck.Survey;
import org.dfra.cli.doctor.RegistrarCheck.SurveyedRegistrar;
import org.dfra.cli.team.UnreadyModule;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Module;
import org.dfra.persona.EmergencyStopAttributes;
import org.dfra.river.lookup.JiniModuleDirectory.ModuleConflict;
import org.dfra.river.lookup.JiniModuleDirectory.UnreadableModule;
import org.dfra.river.remote.ModuleAdmin;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** What is found of lookup services and clocks. */
class TeamChecksTest {

  private static final String HERE = "jini://192.0.2.10:4160";

  @Test
  void aLookupServiceThatAnswersIsReported() throws Exception {
    assertThat(seen(new SurveyedRegistrar(HERE, List.of("field"), false, Duration.ofMillis(3))))
        .isEqualTo(Finding.ok(Subject.REGISTRAR, HERE + " of group field answers in 3.0 ms"));
    assertThat(
            seen(new SurveyedRegistrar(HERE, List.of(), false, Duration.ofMillis(900))).verdict())
        .isEqualTo(Verdict.WARN);
    assertThat(seen(new SurveyedRegistrar("an-id", List.of(), false, null)))
        .returns(Verdict.FAIL, Finding::verdict)
        .returns("an-id was found and does not answer", Finding::what);
  }

  @Test
  void aGroupThatOnlyThisComputerReachesIsAWarning() throws Exception {
    String loopback = "jini://127.0.0.1:4160";
    assertThat(seen(new SurveyedRegistrar(loopback, List.of("field"), true, Duration.ofMillis(3))))
        .returns(Verdict.WARN, Finding::verdict)
        .satisfies(finding -> assertThat(finding.remedy()).contains("DFRA_HOST"));
    assertThat(
            seen(new SurveyedRegistrar(loopback, List.of(), true, Duration.ofMillis(3))).verdict())
        .as("nobody looks for it")
        .isEqualTo(Verdict.OK);
  }

  @Test
  void aLongerWaitIsLongerForEachPeer() {
    assertThat(TeamSurvey.deadline(Duration.ofSeconds(2))).isEqualTo(Duration.ofMillis(800));
    assertThat(TeamSurvey.deadline(Duration.ofSeconds(60))).isEqualTo(Duration.ofSeconds(6));
  }

  private static Finding seen(SurveyedRegistrar seen) throws InterruptedException {
    return new RegistrarCheck(() -> new Survey(List.of(seen), List.of()), List.of(), false)
        .run()
        .get(0);
  }

  @Test
  void aLocatorThatIsSilentIsAFailureIfSomebodyReliesOnIt() throws Exception {
    RegistrarCheck.Search silent = () -> new Survey(List.of(), List.of(HERE + "/"));
    assertThat(new RegistrarCheck(silent, List.of(HERE), false).run())
        .singleElement()
        .returns(Verdict.FAIL, Finding::verdict)
        .returns("none answers at " + HERE, Finding::what);
    assertThat(new RegistrarCheck(silent, List.of(), true).run())
        .singleElement()
        .returns(Verdict.FAIL, Finding::verdict)
        .returns("that of this host at " + HERE + " does not answer", Finding::what);
    assertThat(new RegistrarCheck(silent, List.of(), false).run())
        .as("the robot was taken down")
        .singleElement()
        .returns(Verdict.WARN, Finding::verdict)
        .returns("none was found", Finding::what);
  }

  @Test
  void clocksThatDifferByMoreThanTheMeasurementDoesAreReported() throws Exception {
    assertThat(clock(20, 5))
        .isEqualTo(
            Finding.ok(Subject.CLOCK, "r's clock is 20 ms ahead of this computer's, ± 5.0 ms"));
    assertThat(clock(-3, 5).what()).isEqualTo("r's clock agrees with this computer's, ± 5.0 ms");
    assertThat(clock(-150, 5))
        .returns(Verdict.WARN, Finding::verdict)
        .returns("r's clock is 150 ms behind this computer's, ± 5.0 ms", Finding::what);
    assertThat(clock(150, 80).verdict()).as("it may be the network").isEqualTo(Verdict.OK);
    assertThat(clock(3000, 5))
        .returns(Verdict.FAIL, Finding::verdict)
        .returns("r's clock is 3.0 s ahead of this computer's, ± 5.0 ms", Finding::what);
    assertThat(clock(null).verdict()).isEqualTo(Verdict.WARN);
  }

  private static Finding clock(int offset, int uncertainty) throws InterruptedException {
    return clock(new NtpClockOffset(Duration.ofMillis(offset), Duration.ofMillis(uncertainty)));
  }

  private static Finding clock(@Nullable NtpClockOffset offset) throws InterruptedException {
    return new ClockCheck(() -> List.of(new RobotClock("r", offset))).run().get(0);
  }

  @Test
  void theQuickestAnswerCounts() throws Exception {
    // Sent at 0, answered 1050, back at 100; sent at 200, answered 1210, back at 210: 5 ms a way.
    InstantSource here = instants(0, 100, 200, 210, 300, 380);
    InstantSource there = instants(1050, 1210, 1390);
    assertThat(NtpClockOffset.measure(3, there::instant, here))
        .isEqualTo(new NtpClockOffset(Duration.ofMillis(1005), Duration.ofMillis(5)));
  }

  @Test
  void anOffsetWithinItsUncertaintyMayBeNone() {
    NtpClockOffset offset = new NtpClockOffset(Duration.ofMillis(-3), Duration.ofMillis(5));
    assertThat(offset.atLeast()).isZero();
    assertThat(new NtpClockOffset(Duration.ofMillis(-30), Duration.ofMillis(5)).atLeast())
        .isEqualTo(Duration.ofMillis(25));
  }

  @Test
  void whatTheOtherClockThrowsIsThrown() {
    assertThatThrownBy(
            () ->
                NtpClockOffset.measure(
                    1,
                    () -> {
                      throw new RemoteException("out of range");
                    },
                    InstantSource.system()))
        .isInstanceOf(RemoteException.class);
  }

  private static InstantSource instants(long... millis) {
    Iterator<Instant> all = Arrays.stream(millis).mapToObj(Instant::ofEpochMilli).iterator();
    return all::next;
  }

  @Test
  void aNameThatTwoRobotsHaveIsAFailureThatNamesBothHosts() throws Exception {
    assertThat(new NameCheck(() -> Map.of("r", List.of("10.0.0.5", "10.0.0.6"))).run())
        .containsExactly(
            Finding.fail(
                Subject.ROBOT_NAME,
                "2 robots are named r, on 10.0.0.5 and 10.0.0.6, so a call to r may reach either",
                "Take one of them down, give it another name in its XML and bring it up again;"
                    + " until then name a module as r@HOST/MODULE."));
    assertThat(new NameCheck(() -> Map.of("r", List.of("10.0.0.5", "10.0.0.5"))).run())
        .as("on one host, each with a phoenix of its own")
        .containsExactly(
            Finding.fail(
                Subject.ROBOT_NAME,
                "2 robots are named r, on 10.0.0.5 and 10.0.0.5, so a call to r may reach either",
                "Take one of them down, give it another name in its XML and bring it up again;"
                    + " until then name a module as r@ID/MODULE, with the first eight digits of its"
                    + " service ID, which module list --json shows."));
    assertThat(new NameCheck(Map::of).run()).isEmpty();
  }

  @Test
  void anEffectorThatIsStoppedForAnEmergencyIsAWarning() throws Exception {
    EmergencyStopAttributes stop =
        new EmergencyStopAttributes(
            true, "ops at 192.0.2.7", Instant.parse("2026-11-21T12:00:00Z"));
    assertThat(
            new StopCheck(
                    () -> List.of(new StopCheck.StoppedEffector("atrv1", "atrv1/drive", stop)))
                .run())
        .containsExactly(
            Finding.warn(
                Subject.EMERGENCY_STOP,
                "atrv1/drive is stopped since 2026-11-21T12:00:00Z, by ops at 192.0.2.7, and"
                    + " executes no commands",
                "When it is safe, release it: ./dfra stop --release atrv1."));
    assertThat(new StopCheck(List::of).run()).isEmpty();
  }

  @Test
  void findsModulesThatAreNotReadyWithTheReason() throws Exception {
    UUID id = new UUID(0, 1);
    ModuleCheck check =
        new ModuleCheck(
            () ->
                new ModuleCheck.UnusableModules(
                    List.of(
                        new UnreadyModule(
                            id, "atrv1/gps", Readiness.INITIALIZING, "its link is being opened"),
                        new UnreadyModule(
                            id, "atrv1/laser", Readiness.FAILED, "its motor stands; unblock it"),
                        new UnreadyModule(id, "atrv1/search", Readiness.PAUSED, "it is paused")),
                    List.of(
                        new UnreadableModule(
                            "atrv2",
                            "lidar",
                            "192.0.2.7",
                            id.toString(),
                            "codebase c refused: it is not pinned; pin the digest")),
                    List.of(
                        new ModuleConflict(
                            "atrv1/drive",
                            id.toString(),
                            "192.0.2.1:4160",
                            List.of("192.0.2.66:4160")))));
    assertThat(check.run())
        .containsExactly(
            Finding.warn(
                Subject.MODULE,
                "atrv1/gps is initializing: its link is being opened",
                "Look at its device and its link; ./dfra module info atrv1/gps shows its"
                    + " parameters and its history."),
            Finding.fail(Subject.MODULE, "atrv1/laser is failed: its motor stands", "Unblock it."),
            Finding.warn(
                Subject.MODULE,
                "atrv2/lidar cannot be used here: codebase c refused: it is not pinned",
                "Pin the digest."),
            Finding.warn(
                Subject.MODULE,
                "atrv1/drive is listed differently by the lookup services at 192.0.2.1:4160, which"
                    + " counts here, and 192.0.2.66:4160",
                "If it was not restarted just now, find out whose those lookup services are."));
  }

  /** A module's proxy that answers one question of its administration. */
  private static Module administered(Callable<Object> getAdmin) {
    return (Module)
        Proxy.newProxyInstance(
            TeamChecksTest.class.getClassLoader(),
            new Class<?>[] {Module.class, Administrable.class},
            (proxy, method, arguments) -> getAdmin.call());
  }

  @Test
  void aRobotsClockIsMeasuredThoughTheProxyOfOneOfItsModulesFails() throws Exception {
    Object clock =
        Proxy.newProxyInstance(
            TeamChecksTest.class.getClassLoader(),
            new Class<?>[] {ModuleAdmin.class},
            (proxy, method, arguments) -> Instant.now());
    Module good = administered(() -> clock);
    Module hostile =
        administered(
            () -> {
              throw new IllegalStateException("this proxy is broken");
            });
    assertThat(TeamSurvey.offset(List.of(hostile, good)).uncertainty())
        .isGreaterThanOrEqualTo(Duration.ZERO);
    assertThatThrownBy(() -> TeamSurvey.offset(List.of(hostile)))
        .isInstanceOf(IllegalStateException.class);
  }
}
