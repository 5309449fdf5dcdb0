package org.dfra.river.bootstrap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;

import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.ConnectException;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.RegistrarDescription;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotDescription.GroupDescription;
import org.dfra.core.config.SourceLocation;
import org.dfra.river.bootstrap.BringUpStep.Kind;
import org.dfra.river.bootstrap.PhoenixInventory.ServiceGroup;
import org.dfra.river.bootstrap.PhoenixInventory.ServiceGroup.RegistrarState;
import org.dfra.river.bootstrap.RobotBootstrap.ServiceReference;
import org.dfra.river.phoenix.Phoenix;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleIdentity;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * On a busy computer phoenix and the registrar miss answers. A command asks again until its own
 * time is over, and carries nothing out twice. The clock is stepped here, so nobody waits.
 */
@Timeout(60)
class MissedAnswersTest {

  private static final Duration TIME = Duration.ofSeconds(60);
  private static final int MISSES = 4;
  private static final int ALL = Integer.MAX_VALUE;

  private static final RobotDescription ROBOT =
      new RobotDescription(
          "r",
          "127.0.0.1",
          List.of("field"),
          List.of(),
          List.of(
              new GroupDescription(
                  "lookup",
                  List.of(),
                  Optional.of(new RegistrarDescription(4161, 0, true, SourceLocation.CODE)),
                  List.of(),
                  SourceLocation.CODE),
              new GroupDescription(
                  "one",
                  List.of(),
                  Optional.empty(),
                  List.of(
                      new ModuleDescription(
                          "r",
                          "gps",
                          "a.Server",
                          "a.Proxy",
                          "a.Driver",
                          null,
                          true,
                          Parameters.of("r/gps", Map.of()),
                          SourceLocation.CODE)),
                  SourceLocation.CODE)),
          Path.of("r.xml"));

  @TempDir Path folder;

  private final AtomicLong nanos = new AtomicLong();
  private final List<BringUpStep> steps = new ArrayList<>();

  private RetryDeadline patience() {
    return new RetryDeadline(
        TIME, nanos::get, () -> nanos.addAndGet(TimeUnit.MILLISECONDS.toNanos(50)));
  }

  private List<ServiceReference> bringUp(PlayedPhoenix phoenix) throws Exception {
    RetryDeadline patience = patience();
    BringUp.ModuleSettings settings =
        new BringUp.ModuleSettings() {
          @Override
          public ModuleActivation activationData(
              ModuleDescription module, ModuleIdentity identity) {
            return new ModuleActivation(
                module, identity.id(), identity.created(), "127.0.0.1", List.of(), List.of());
          }

          @Override
          public Path stateFolder(ModuleDescription module) {
            return RobotBootstrap.moduleStateFolder(folder, "r", module.name());
          }
        };
    return new BringUp(
            phoenix.calls(folder),
            ROBOT,
            new BootstrapLoader(
                phoenix.calls(folder), "r", ROBOT.administration(), Optional.empty(), patience),
            new RobotRegistrar(ROBOT, "127.0.0.1", false, folder),
            settings,
            patience,
            steps::add)
        .run();
  }

  @Test
  void aRobotIsBroughtUpAndDownThoughEveryQuestionMissesItsFirstAnswers() throws Exception {
    PlayedPhoenix phoenix = new PlayedPhoenix(MISSES);
    assertThat(bringUp(phoenix))
        .extracting(ServiceReference::name)
        .containsExactly("r/registrar", "r/gps");
    assertThat(steps)
        .extracting(BringUpStep::name, BringUpStep::kind)
        .containsExactly(tuple("r/registrar", Kind.STARTED), tuple("r/gps", Kind.STARTED));
    assertThat(phoenix.groups()).as("none twice").containsExactly("r.lookup", "r.one");
    assertThat(phoenix.objects()).containsExactly(BootstrapLoader.REGGIE, "a.Server");
    assertThat(PlayedPhoenix.Registrar.port).isEqualTo(4161);
    assertThat(PlayedPhoenix.Registrar.groups).containsExactly("field");
    for (String method : List.of("groupStatus", "registerGroup", "registerObject", "activate")) {
      assertThat(phoenix.calls(method)).as(method).isGreaterThan(1);
    }

    new RobotRemoval(phoenix.calls(folder), patience(), TIME).remove("r");
    assertThat(phoenix.objects()).isEmpty();
    assertThat(phoenix.groups()).isEmpty();
  }

  @Test
  void theStatusIsReadThoughEveryQuestionMissesItsFirstAnswers() throws Exception {
    PlayedPhoenix phoenix = new PlayedPhoenix(0);
    List<ServiceReference> unused = bringUp(phoenix);
    phoenix.miss(MISSES);
    assertThat(PhoenixInventory.groups(phoenix.calls(folder).admin(), patience()))
        .extracting(ServiceGroup::name, ServiceGroup::registrar, ServiceGroup::runningModules)
        .containsExactly(
            tuple("lookup", RegistrarState.RUNNING, Set.of()),
            tuple("one", RegistrarState.NONE, Set.of("gps")));
    assertThat(phoenix.calls("groupStatus")).isGreaterThan(MISSES);
  }

  @Test
  void aPhoenixThatNeverAnswersIsReportedWhenTheTimeIsOver() {
    PlayedPhoenix phoenix = new PlayedPhoenix(ALL);
    assertThatThrownBy(() -> bringUp(phoenix))
        .isInstanceOf(NoAnswerException.class)
        .hasMessageMatching(
            "phoenix, or what it has started, did not answer within 60 s \\(getActivationGroups"
                + " [^\\n;]*\\); see whether its process hangs or the computer is overloaded:"
                + " \\./dfra doctor");
    assertThat(Duration.ofNanos(nanos.get())).isEqualTo(TIME);
    assertThat(steps).isEmpty();
  }

  @Test
  void aRegistrarThatNeverAnswersIsReportedWhenTheTimeIsOver() {
    PlayedPhoenix phoenix = new PlayedPhoenix(0);
    PlayedPhoenix.Registrar.misses = new PlayedPhoenix.Misses(ALL);
    assertThatThrownBy(() -> bringUp(phoenix))
        .hasMessageContaining("r/registrar: phoenix, or what it has started, did not answer within")
        .hasMessageContaining("getUnicastPort");
    assertThat(Duration.ofNanos(nanos.get())).isEqualTo(TIME);
  }

  /** A process that may be a phoenix, as far as its command line tells; ends with its input. */
  private Process owner() throws Exception {
    Process owner = new ProcessBuilder("sh", "-c", "read line", Phoenix.class.getName()).start();
    Files.createDirectories(folder.resolve("journal"));
    Files.writeString(folder.resolve("journal/phoenix.lock"), owner.pid() + "\n");
    return owner;
  }

  private PhoenixProcess process() {
    return new PhoenixProcess("127.0.0.1", 1, -1, folder);
  }

  @Test
  void onesPresenceIsAskedForAgainUntilTheTimeIsOver() throws Exception {
    Process owner = owner();
    try {
      PlayedPhoenix busy = new PlayedPhoenix(MISSES);
      assertThat(process().groupStatus(busy.calls(folder).admin(), patience())).isEmpty();
      assertThat(busy.calls("groupStatus")).isEqualTo(MISSES + 1);

      nanos.set(0);
      assertThatThrownBy(
              () -> process().groupStatus(new PlayedPhoenix(ALL).calls(folder).admin(), patience()))
          .isInstanceOf(NoAnswerException.class)
          .hasMessageStartingWith("phoenix at 127.0.0.1:1 did not answer within 60 s (groupStatus ")
          .hasMessageNotContaining("\n");
      assertThat(Duration.ofNanos(nanos.get())).isEqualTo(TIME);
    } finally {
      owner.getOutputStream().close();
      assertThat(owner.waitFor(20, TimeUnit.SECONDS)).isTrue();
    }
  }

  @Test
  void oneThatHasCertainlyEndedIsNotAskedAgain() throws Exception {
    Process ended = owner();
    ended.getOutputStream().close();
    assertThat(ended.waitFor(20, TimeUnit.SECONDS)).isTrue();
    PlayedPhoenix phoenix = new PlayedPhoenix(ALL);
    assertThatThrownBy(() -> process().groupStatus(phoenix.calls(folder).admin(), patience()))
        .isInstanceOf(ConnectException.class);
    assertThat(phoenix.calls("groupStatus")).isOne();
  }

  @Test
  void whereNobodyListensNoneIsAwaited() throws Exception {
    Process owner = owner(); // it may be about to begin, or to end
    try (Socket held = new Socket()) {
      held.bind(new InetSocketAddress("127.0.0.1", 0));
      PhoenixProcess none = new PhoenixProcess("127.0.0.1", held.getLocalPort(), -1, folder);
      assertThatThrownBy(() -> none.groupStatus(none.admin(), patience()))
          .isInstanceOf(RemoteException.class)
          .isNotInstanceOf(NoAnswerException.class);
      assertThat(nanos).as("time that was waited").hasValue(0);
    } finally {
      owner.getOutputStream().close();
      assertThat(owner.waitFor(20, TimeUnit.SECONDS)).isTrue();
    }
  }
}
