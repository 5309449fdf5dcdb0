package org.dfra.river.phoenix.stop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.UUID;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import net.jini.jeri.BasicJeriExporter;
import org.dfra.core.host.FreePorts;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Anybody may answer at phoenix's port, so a report is read within tight limits. */
@Timeout(60)
class StopLocatorTest {

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  /** A phoenix that reports whatever the test wants. */
  private static final class PlayedPhoenix implements StopService {

    private volatile StopReport report = new StopReport(List.of(), List.of(), List.of());

    @Override
    public StopReport emergencyStop(List<String> robots, String by) {
      return report;
    }
  }

  private final PlayedPhoenix phoenix = new PlayedPhoenix();
  private int port;
  private BasicJeriExporter exporter;

  @BeforeEach
  void export() throws Exception {
    port = FreePorts.allocate();
    exporter =
        new BasicJeriExporter(
            Endpoints.tcp("127.0.0.1", port),
            new DeadlineILFactory(),
            false,
            true,
            StopLocator.IDENTITY);
    Object unused = exporter.export(phoenix);
  }

  @AfterEach
  void unexport() {
    boolean unused = exporter.unexport(true);
  }

  private StopReport stop() throws RemoteException {
    return StopLocator.proxyAt("127.0.0.1", port, PATIENCE).emergencyStop(List.of(), "ops");
  }

  private static EffectorStopResult effector(int number) {
    EmergencyStopState state =
        new EmergencyStopState(
            true, "ops at 192.0.2.7", Instant.EPOCH, true, null, Duration.ofSeconds(1));
    return new EffectorStopResult(
        UUID.randomUUID(), "robot" + number % 200 + "/drive" + number, false, state, null);
  }

  private static List<String> robots(int count) {
    return IntStream.range(0, count).mapToObj(i -> "robot" + i).toList();
  }

  @Test
  void theReportOfALargeFleetIsRead() throws Exception {
    phoenix.report =
        new StopReport(
            robots(200),
            IntStream.range(0, 2000).mapToObj(StopLocatorTest::effector).toList(),
            List.of(new UnconfirmedGroup("robot1", "robot1.wheels", "it hangs")));
    assertThat(stop()).isEqualTo(phoenix.report);
  }

  static Stream<StopReport> largeReports() {
    return Stream.of(
        new StopReport(List.of("x".repeat(2 << 20)), List.of(), List.of()),
        new StopReport(robots(70_000), List.of(), List.of()),
        new StopReport(
            List.of(),
            List.of(),
            IntStream.range(0, 100)
                .mapToObj(i -> new UnconfirmedGroup("r" + i, "g", "y".repeat(20_000)))
                .toList()));
  }

  @ParameterizedTest(name = "{index}")
  @MethodSource("largeReports")
  void aReportThatIsTooLargeIsRefused(StopReport report) {
    phoenix.report = report;
    assertThatThrownBy(this::stop)
        .isInstanceOf(RemoteException.class)
        .hasStackTraceContaining("refused to read on");
  }
}
