package org.dfra.examples.recruit;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.reflect.Proxy;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.function.BiFunction;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.agent.RequesterPhase;
import org.dfra.agent.ResponderPhase;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.RasterSearch;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleQuery;
import org.dfra.event.Delivery;
import org.dfra.event.ModuleEvent;
import org.dfra.event.ModuleListener;
import org.dfra.event.Subscription;
import org.dfra.examples.recruit.ResumptionCheck.ResumptionFault;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.report.progress.ProgressReporter;
import org.junit.jupiter.api.Test;

/** Whether interrupted searches were resumed is judged by their reports. */
class BackgroundSearchesTest {

  private static final Instant BEGIN = Instant.parse("2026-11-22T00:00:00Z");

  /** Called away after 10 s, free after 20 s. */
  private static final List<RecruitmentStatus> HELPED =
      List.of(agent(10, ResponderPhase.TRAVELLING), agent(20, ResponderPhase.FREE));

  private final StringWriter output = new StringWriter();
  private final Map<String, ModuleListener> listeners = new HashMap<>();
  private final Map<String, UUID> goals = new HashMap<>();
  private final List<String> cancelled = new ArrayList<>();
  private final BackgroundSearches searches =
      new BackgroundSearches(
          new ProgressReporter(new PrintWriter(output), () -> 0),
          fake(ModuleDirectory.class, this::directory),
          new LocalFrame(new GeoPosition(48, 11, 0)),
          Duration.ofMillis(20));

  private static RecruitmentStatus agent(int second, ResponderPhase phase) {
    return new RecruitmentStatus(
        BEGIN.plusSeconds(second), RequesterPhase.IDLE, null, phase, "uav", 0, "as it is");
  }

  private static <T> T fake(Class<T> type, BiFunction<String, Object[], Object> answers) {
    return type.cast(
        Proxy.newProxyInstance(
            BackgroundSearchesTest.class.getClassLoader(),
            new Class<?>[] {type},
            (self, method, arguments) -> answers.apply(method.getName(), arguments)));
  }

  private Object directory(String method, Object[] arguments) {
    for (String robot : List.of("ugv1", "ugv2", "ugv3")) {
      if (arguments[0].equals(ModuleQuery.of(RasterSearch.class).robot(robot))) {
        return fake(RasterSearch.class, (name, all) -> search(robot, name, all));
      }
    }
    throw new UnsupportedOperationException(method);
  }

  /** Stands for a robot's search. */
  private Object search(String robot, String method, Object[] arguments) {
    return switch (method) {
      case "pursue" -> goals.computeIfAbsent(robot, name -> UUID.randomUUID());
      case "subscribe" -> {
        listeners.put(robot, (ModuleListener) arguments[0]);
        yield fake(Subscription.class, (name, all) -> listeners.remove(robot));
      }
      case "status" -> searches.last(robot).orElseThrow();
      case "cancel" -> {
        cancelled.add(robot);
        yield null;
      }
      default -> throw new UnsupportedOperationException(method);
    };
  }

  /** Has a robot's search report its status. */
  private void report(String robot, int second, Phase phase, double done) throws RemoteException {
    BehaviorStatus status =
        new BehaviorStatus(
            BEGIN.plusSeconds(second), goals.get(robot), phase, "it is as it is", done, 0);
    listeners
        .get(robot)
        .notify(
            new Delivery(
                robot + "/search", 0, second, 0, BEGIN, new ModuleEvent.NewReading(status)));
  }

  private void begun(String robot) throws Exception {
    searches.begin(robot, 0, 0);
    report(robot, 1, Phase.RUNNING, 0.25);
  }

  private String output() {
    return output.toString().replaceAll("\\s+", " "); // lines may end anywhere
  }

  @Test
  void searchesThatGoOnPassAndOthersAreNamed() throws Exception {
    begun("ugv1");
    begun("ugv2");
    for (String robot : List.of("ugv1", "ugv2")) {
      report(robot, 11, Phase.PAUSED, 0.25);
    }
    report("ugv1", 30, Phase.RUNNING, 0.5);
    Map<String, ResumptionFault> faults = searches.end(Map.of("ugv1", HELPED, "ugv2", HELPED));
    assertThat(faults).containsOnlyKeys("ugv2");
    assertThat(faults.get("ugv2").hadSearched()).isTrue();
    assertThat(output())
        .contains("ugv2 has not continued the search that it interrupted, which is PAUSED")
        .contains(
            "ugv1, which interrupted its search to help and then continued it, has searched 50 %")
        .contains("ugv2 has searched 25 % of its quarter: it is as it is.");
    assertThat(cancelled).containsExactlyInAnyOrder("ugv1", "ugv2");
  }

  @Test
  void aRobotThatWasRecruitedWithoutSearchingIsNamed() throws Exception {
    begun("ugv1");
    report("ugv1", 9, Phase.SUCCEEDED, 1);
    Map<String, ResumptionFault> faults = searches.end(Map.of("ugv1", HELPED, "ugv3", HELPED));
    assertThat(faults).containsOnlyKeys("ugv1", "ugv3");
    assertThat(faults.values()).noneMatch(ResumptionFault::hadSearched);
    assertThat(output())
        .contains("ugv1 was not searching when it was recruited: its search was SUCCEEDED")
        .contains("ugv3 was not searching when it was recruited: it had no search.");
  }

  @Test
  void whatWasNeverLeftCannotGoOnNorFailTo() throws Exception {
    begun("ugv1");
    begun("ugv2");
    report("ugv2", 12, Phase.FAILED, 0.25);
    assertThat(searches.end(Map.of())).isEmpty();
    assertThat(output()).contains("ugv1 has searched 25 %", "ugv2 has searched 25 %");
  }

  @Test
  void aRobotThatDiedIsNotAwaited() throws Exception {
    begun("ugv1");
    searches.forget("ugv1");
    assertThat(listeners).as("whom it still report").isEmpty();
    assertThat(searches.end(Map.of())).isEmpty();
    assertThat(cancelled).isEmpty();
    assertThat(output()).doesNotContain("ugv1 has searched");
  }

  @Test
  void theLastReportIsKnown() throws Exception {
    assertThat(searches.last("ugv1")).isEmpty();
    begun("ugv1");
    report("ugv1", 5, Phase.RUNNING, 0.5);
    assertThat(searches.last("ugv1"))
        .hasValueSatisfying(last -> assertThat(last.completion()).isEqualTo(0.5));
    searches.close();
    assertThat(listeners).isEmpty();
  }
}
