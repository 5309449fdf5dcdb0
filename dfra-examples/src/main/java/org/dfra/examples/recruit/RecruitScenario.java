package org.dfra.examples.recruit;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.dfra.agent.HelpCall;
import org.dfra.agent.RecruitmentAgent;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.agent.RequesterPhase;
import org.dfra.agent.ResponderPhase;
import org.dfra.core.config.RobotDescription;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleQuery;
import org.dfra.examples.mission.monitor.RobotStartup;
import org.dfra.examples.recruit.ResumptionCheck.ResumptionFault;
import org.dfra.flow.effector.FlightEffector;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.report.progress.DemoAssertions;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.sim.world.World;

/** The steps of the demonstration. */
final class RecruitScenario {

  private static final String REQUESTER = "uav";
  private static final String PERCEPT = "mine";
  private static final Duration PATIENCE = HelpRequester.PATIENCE;
  private static final Duration LOOKED_FOR = Duration.ofMinutes(4);
  private static final Duration LONG_STAY = Duration.ofMinutes(2);

  /** Distance after which a travelling helper is killed, metres. */
  private static final double ON_ITS_WAY = 2;

  /** After which a helper is released, robots' time. */
  private static final Duration OBSERVED = Duration.ofSeconds(8);

  /** How long a helper stays that is not released, robots' time. */
  private static final Duration SHORT_STAY = Duration.ofSeconds(15);

  private final ProgressReporter progress;
  private final DemoTeam team;
  private final ModuleDirectory directory;
  private final AgentMonitor monitor;
  private final World world;
  private final TrueTrajectories ways;
  private final InstantSource clock;
  private final LocalFrame frame;
  private final BackgroundSearches searches;

  /**
   * @param searches none has started
   * @param frame the world's
   * @param clock the robots'
   */
  RecruitScenario(
      ProgressReporter progress,
      DemoTeam team,
      ModuleDirectory directory,
      AgentMonitor monitor,
      BackgroundSearches searches,
      World world,
      TrueTrajectories ways,
      LocalFrame frame,
      InstantSource clock) {
    this.progress = progress;
    this.team = team;
    this.directory = directory;
    this.monitor = monitor;
    this.world = world;
    this.ways = ways;
    this.clock = clock;
    this.frame = frame;
    this.searches = searches;
  }

  void play() throws Exception {
    for (RobotDescription each : team.bodies()) {
      RobotStartup.awaitReady(directory, each);
    }
    int robots = team.bodies().size();
    DemoAssertions.await(
        "that all agents appear", PATIENCE, () -> monitor.listening().size() == robots);
    RecruitmentAgent uav =
        directory.proxyFor(ModuleQuery.of(RecruitmentAgent.class).robot(REQUESTER));
    HelpRequester calls = new HelpRequester(progress, REQUESTER, uav, monitor, frame);
    progress.say("All %d agents are found.", robots);
    searches.begin("ugv1", 4.5, 3);
    searches.begin("ugv2", 22, 3);
    searches.begin("ugv3", 4.5, 18);
    searches.begin("ugv4", 22, 18);
    refuse(calls);
    FlightEffector flight =
        directory.proxyFor(ModuleQuery.of(FlightEffector.class).robot(REQUESTER));
    try (HoverCaller scout = new HoverCaller(progress, REQUESTER, flight, frame)) {
      oneComesAndIsReleased(scout, calls);
      String dead = oneDiesOnItsWay(scout, calls);
      theRequesterIsCutOff(scout, calls, dead);
      scout.land();
      judge(dead);
    }
  }

  private GeoPosition place(double east, double north) {
    return frame.toGeo(new LocalPosition(east, north, 0));
  }

  private void refuse(HelpRequester calls) throws Exception {
    progress.section("asking for what cannot be", "An impossible call is refused");
    HelpCall gold = new HelpCall("gold", place(12, 11), SHORT_STAY, LOOKED_FOR);
    calls.awaitOthers(gold);
    calls.requireRefused(gold);
    calls.requireRefused(new HelpCall(PERCEPT, place(60, 11), SHORT_STAY, LOOKED_FOR));
  }

  private void oneComesAndIsReleased(HoverCaller scout, HelpRequester calls) throws Exception {
    progress.section("recruiting one", "A helper comes, observes, and is released");
    HelpCall call = new HelpCall(PERCEPT, place(12, 11), LONG_STAY, LOOKED_FOR);
    scout.lookAt(call.position());
    ProgressReporter.Stopwatch watch = progress.stopwatch();
    progress.say("%s comes.", calls.call(call, Set.of()));
    progress.figure("call to a robot on its way", watch.elapsed(), Duration.ofSeconds(60));
    String helper = calls.awaitArrival();
    Instant enough = clock.instant().plus(OBSERVED);
    progress.say("%s observes for %d s of the robots' time.", helper, OBSERVED.toSeconds());
    DemoAssertions.await(
        "that " + helper + " has observed", PATIENCE, () -> clock.instant().isAfter(enough));
    calls.release(helper);
  }

  /** Returns the robot that died. */
  private String oneDiesOnItsWay(HoverCaller scout, HelpRequester calls) throws Exception {
    progress.section("killing a helper on its way", "A helper dies on its way, and is replaced");
    HelpCall call = new HelpCall(PERCEPT, place(27, 12), LONG_STAY, LOOKED_FOR);
    scout.lookAt(call.position());
    String dead = calls.call(call, Set.of());
    Instant setOut = clock.instant();
    progress.say("%s comes.", dead);
    DemoAssertions.await(
        "that " + dead + " is on its way",
        PATIENCE,
        () -> ways.displacementSince(dead, setOut) > ON_ITS_WAY);
    long process = team.process(dead);
    ProgressReporter.Stopwatch watch = progress.stopwatch();
    team.kill(dead);
    monitor.noteDeath(clock.instant(), dead, "dies: only a stopped vehicle remains");
    searches.forget(dead);
    progress.say(
        "%s dies: its agent's process %d is killed, its registrar, drivers and behaviours are closed."
            + " Phoenix restarts the agent, which finds no robot to drive.",
        dead, process);
    progress.say("%s comes instead.", calls.awaitTravelling(Set.of(dead)));
    progress.figure("death to another on its way", watch.elapsed(), PATIENCE);
    calls.release(calls.awaitArrival());
    return dead;
  }

  private void theRequesterIsCutOff(HoverCaller scout, HelpRequester calls, String dead)
      throws Exception {
    progress.section("cutting the requester off", "The requester becomes unreachable");
    HelpCall call = new HelpCall(PERCEPT, place(16, 18), SHORT_STAY, LOOKED_FOR);
    scout.lookAt(call.position());
    progress.say("%s comes.", calls.call(call, Set.of(dead)));
    String helper = calls.awaitArrival();
    team.signal("STOP", REQUESTER);
    try {
      monitor.noteReachable(clock.instant(), REQUESTER, false);
      progress.say(
          "The agent of %s is suspended (process %d): it receives and sends nothing. %s has granted"
              + " it a lease of %d s of the robots' time.",
          REQUESTER, team.process(REQUESTER), helper, SHORT_STAY.toSeconds());
      calls.await(helper, ResponderPhase.FREE);
      progress.say("%s is free again without a release, since its lease has expired.", helper);
    } finally {
      team.signal("CONT", REQUESTER);
      monitor.noteReachable(clock.instant(), REQUESTER, true);
    }
    calls.await(RequesterPhase.IDLE);
  }

  private void judge(String dead) throws Exception {
    progress.section("judging", "Results");
    Map<String, List<RecruitmentStatus>> recruited = monitor.statuses();
    recruited.keySet().retainAll(monitor.helpers());
    recruited.remove(dead);
    Collection<ResumptionFault> faults = searches.end(recruited).values();
    long idle = faults.stream().filter(each -> !each.hadSearched()).count();
    Set<String> bound =
        monitor.statuses().entrySet().stream()
            .filter(each -> !each.getKey().equals(dead))
            .filter(each -> last(each.getValue()).responderPhase() != ResponderPhase.FREE)
            .map(Map.Entry::getKey)
            .collect(Collectors.toSet());
    progress.say("%d messages were sent; a call to all counts once.", monitor.messages().size());
    progress.figure("robots that are not free at the end", bound.size(), 0, "");
    progress.figure("seconds in which two helped at once", monitor.overlapSeconds(), 0, "s");
    progress.figure("recruited robots that had not been searching", idle, 0, "");
    progress.figure("searches that were left and did not go on", faults.size() - idle, 0, "");
    progress.figure("collisions", world.groundTruth().collisions().size(), 0, "");
  }

  private static RecruitmentStatus last(List<RecruitmentStatus> all) {
    return all.get(all.size() - 1);
  }
}
