package org.dfra.examples.recruit;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.agent.ResponderPhase;
import org.dfra.examples.mission.MissionProgressListener.MissionEvent;
import org.dfra.examples.recruit.Conversations.Attempt;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.sim.world.GroundTruth.GroundTruthPose;

/**
 * The events of the demonstration in order, with places: statuses of agents, compared with the
 * robots' true positions.
 */
final class DemoTimeline {

  /**
   * @param mark the event
   * @param east its place, metres in the world's frame
   * @param north likewise
   */
  record Event(MissionEvent mark, double east, double north) {}

  private final Instant began;
  private final LocalFrame frame;
  private final AgentMonitor monitor;
  private final TrueTrajectories ways;

  /**
   * @param began the robots' time to which reported seconds are relative
   * @param frame the world's
   */
  DemoTimeline(Instant began, LocalFrame frame, AgentMonitor monitor, TrueTrajectories ways) {
    this.began = began;
    this.frame = frame;
    this.monitor = monitor;
    this.ways = ways;
  }

  /** Seconds of the robots' time since the demonstration began. */
  double seconds(Instant time) {
    return Duration.between(began, time).toMillis() / 1000.0;
  }

  /** Transforms latitude and longitude to the world's frame. */
  LocalPosition place(GeoPosition place) {
    return frame.toLocal(place);
  }

  /** All events, the first first. */
  List<Event> events() {
    List<Event> all = new ArrayList<>();
    for (Attempt each : Conversations.of(monitor.messages())) {
      LocalPosition at = place(each.asked().position());
      String what =
          each.attempt() == 1
              ? "calls for help here: call " + each.call()
              : "calls again: call " + each.call() + ", attempt " + each.attempt();
      if (each.attempt() == 1) {
        all.add(new Event(mark(each.begun(), each.requester(), what), at.east(), at.north()));
      } else {
        all.add(of(each.begun(), each.requester(), what));
      }
    }
    monitor.statuses().forEach((robot, reported) -> all.addAll(helped(robot, reported)));
    monitor.noted().forEach(each -> all.add(of(each.time(), each.robot(), each.what())));
    all.sort(Comparator.comparingDouble(each -> each.mark().time()));
    return all;
  }

  /** When a robot set out, was there, and was free again. */
  private List<Event> helped(String robot, List<RecruitmentStatus> reported) {
    List<Event> all = new ArrayList<>();
    ResponderPhase last = ResponderPhase.FREE;
    for (RecruitmentStatus each : reported) {
      ResponderPhase phase = each.responderPhase();
      boolean wasThere = isThere(last);
      if (phase == ResponderPhase.TRAVELLING && last != phase) {
        all.add(of(each.measured(), robot, "leaves to help " + each.helpedRobot()));
      } else if (isThere(phase) && !wasThere) {
        all.add(of(each.measured(), robot, "has arrived to help " + each.helpedRobot()));
      } else if (!phase.isCommitted() && last.isCommitted()) {
        all.add(of(each.measured(), robot, each.lastChange().replaceFirst("^it ", "")));
      }
      last = phase;
    }
    return all;
  }

  private static boolean isThere(ResponderPhase phase) {
    return phase.isCommitted() && phase != ResponderPhase.TRAVELLING;
  }

  private Event of(Instant time, String robot, String what) {
    GroundTruthPose pose = ways.at(robot, time);
    return new Event(mark(time, robot, what), pose.east(), pose.north());
  }

  private MissionEvent mark(Instant time, String robot, String what) {
    return new MissionEvent(seconds(time), robot, what);
  }

  /** The statuses of each robot, in the order received. */
  Map<String, List<RecruitmentStatus>> statuses() {
    return monitor.statuses();
  }

  /** The conversations. */
  List<Attempt> conversations() {
    return Conversations.of(monitor.messages());
  }

  /** The robots' true paths. */
  Map<String, double[][]> trajectories() {
    return ways.all();
  }
}
