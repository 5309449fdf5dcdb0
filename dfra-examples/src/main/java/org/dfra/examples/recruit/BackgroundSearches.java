package org.dfra.examples.recruit;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.RasterGoal;
import org.dfra.behavior.RasterSearch;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleQuery;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent;
import org.dfra.event.Subscription;
import org.dfra.examples.harness.GoalSubmission;
import org.dfra.examples.recruit.ResumptionCheck.ResumptionFault;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.module.NotReadyException;
import org.dfra.report.progress.DemoAssertions;
import org.dfra.report.progress.ProgressReporter;

/**
 * The work of the robots until they are recruited, which they resume afterwards. Keeps the status
 * of the searches. Thread-safe.
 */
final class BackgroundSearches implements AutoCloseable {

  /** Usual timeout for a search. */
  static final Duration PATIENCE = Duration.ofSeconds(120);

  /** Metres; so narrow that no search ends before the last call. */
  private static final double SWATH = 0.85;

  private static final double WIDTH = 13.5; // to the east, metres
  private static final double DEPTH = 8; // to the north, metres

  /** Queue length of each subscription, while this process is slow. */
  private static final int KEPT = 512;

  private final ProgressReporter progress;
  private final ModuleDirectory directory;
  private final LocalFrame frame;
  private final Duration patience;

  // path by robot
  @GuardedBy("this")
  private final Map<String, RasterSearch> under = new TreeMap<>();

  @GuardedBy("this")
  private final Map<String, Subscription> subscriptions = new TreeMap<>();

  @GuardedBy("this")
  private final Map<String, List<BehaviorStatus>> received = new TreeMap<>();

  /**
   * @param frame the world's
   * @param patience timeout for a search, real time
   */
  BackgroundSearches(
      ProgressReporter progress, ModuleDirectory directory, LocalFrame frame, Duration patience) {
    this.progress = progress;
    this.directory = directory;
    this.frame = frame;
    this.patience = patience;
  }

  /**
   * Starts a robot's search of a rectangle by raster.
   *
   * @param west of its south-western corner, metres in the world's frame
   * @param south likewise
   */
  void begin(String robot, double west, double south) throws Exception {
    progress.step("having " + robot + " search");
    RasterSearch search = directory.proxyFor(ModuleQuery.of(RasterSearch.class).robot(robot));
    Subscription subscription =
        search.subscribe(delivery -> received(robot, delivery), DeliveryPolicy.keepLast(KEPT));
    synchronized (this) {
      subscriptions.put(robot, subscription);
      under.put(robot, search);
    }
    List<LocalPosition> corners =
        List.of(
            new LocalPosition(west, south, 0),
            new LocalPosition(west + WIDTH, south, 0),
            new LocalPosition(west + WIDTH, south + DEPTH, 0),
            new LocalPosition(west, south + DEPTH, 0));
    RasterGoal goal =
        new RasterGoal(corners.stream().map(frame::toGeo).toList(), SWATH, 0.8 * SWATH, false);
    DemoAssertions.await(
        "that " + robot + " starts its search",
        patience,
        () -> {
          try {
            GoalSubmission.submit(search, goal);
            return true;
          } catch (NotReadyException e) {
            return false;
          }
        });
    progress.say("%s searches its quarter of the field by raster.", robot);
  }

  private synchronized void received(String robot, Delivery delivery) {
    if (delivery.event() instanceof ModuleEvent.NewReading fresh
        && fresh.reading() instanceof BehaviorStatus status) {
      received.computeIfAbsent(robot, name -> new ArrayList<>()).add(status);
    }
  }

  private synchronized List<BehaviorStatus> statuses(String robot) {
    return List.copyOf(received.getOrDefault(robot, List.of()));
  }

  /** The last status of a robot's search; empty if there is none. */
  synchronized Optional<BehaviorStatus> last(String robot) {
    List<BehaviorStatus> all = received.getOrDefault(robot, List.of());
    return all.isEmpty() ? Optional.empty() : Optional.of(all.get(all.size() - 1));
  }

  /** The robot no longer exists. */
  void forget(String robot) {
    Subscription ending;
    synchronized (this) {
      under.remove(robot);
      ending = subscriptions.remove(robot);
    }
    if (ending != null) {
      ending.close();
    }
  }

  /**
   * Checks whether each recruited robot had been searching and resumed that search, reports the
   * result, and ends all searches. A robot that has yet to make progress is given time.
   *
   * @param recruited statuses of the agents of recruited robots, in the order received, by robot
   * @return the faults, by robot
   */
  Map<String, ResumptionFault> end(Map<String, List<RecruitmentStatus>> recruited)
      throws Exception {
    Map<String, ResumptionFault> faults = new TreeMap<>();
    for (Map.Entry<String, List<RecruitmentStatus>> each : recruited.entrySet()) {
      String robot = each.getKey();
      progress.step("waiting until " + robot + " continues its search");
      boolean unused =
          DemoAssertions.holdsWithin(patience, () -> isDecided(robot, each.getValue()));
      Optional<ResumptionFault> fault = ResumptionCheck.fault(each.getValue(), statuses(robot));
      fault.ifPresent(
          what -> {
            faults.put(robot, what);
            progress.say("%s %s.", robot, what.why());
          });
    }
    Map<String, RasterSearch> ending;
    synchronized (this) {
      ending = new TreeMap<>(under);
    }
    for (Map.Entry<String, RasterSearch> each : ending.entrySet()) {
      String robot = each.getKey();
      boolean hasResumed = recruited.containsKey(robot) && !faults.containsKey(robot);
      print(robot, hasResumed, each.getValue());
      each.getValue().cancel();
    }
    return faults;
  }

  /** Whether waiting for it cannot change the result any more. */
  private boolean isDecided(String robot, List<RecruitmentStatus> agent) {
    Optional<ResumptionFault> fault = ResumptionCheck.fault(agent, statuses(robot));
    boolean isOver =
        last(robot)
            .map(BehaviorStatus::phase)
            .filter(phase -> phase == Phase.FAILED || phase == Phase.CANCELLED)
            .isPresent();
    return isOver || fault.map(what -> !what.hadSearched()).orElse(true);
  }

  private void print(String robot, boolean hasResumed, RasterSearch search) throws RemoteException {
    BehaviorStatus status = search.status();
    progress.say(
        "%s%s has searched %.0f %% of its quarter: %s.",
        robot,
        hasResumed ? ", which interrupted its search to help and then continued it," : "",
        100 * status.completion(),
        status.activity());
  }

  @Override
  public void close() {
    List<Subscription> ending;
    synchronized (this) {
      ending = List.copyOf(subscriptions.values());
      subscriptions.clear();
    }
    ending.forEach(Subscription::close);
  }
}
