package org.dfra.examples.recruit;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.examples.map.FieldMap;
import org.dfra.examples.recruit.Conversations.Attempt;
import org.dfra.examples.recruit.DemoTimeline.Event;
import org.dfra.geometry.LocalFrame;
import org.dfra.recruit.message.RecruitmentMessage;
import org.dfra.recruit.message.RecruitmentMessage.Accept;
import org.dfra.recruit.message.RecruitmentMessage.Arrival;
import org.dfra.recruit.message.RecruitmentMessage.Help;
import org.dfra.recruit.message.RecruitmentMessage.ResponderId;
import org.dfra.recruit.message.SentMessage;
import org.dfra.report.plot.Axis;
import org.dfra.report.plot.LinePanel;
import org.dfra.report.plot.Page;
import org.dfra.report.plot.PathPanel;
import org.dfra.report.plot.SequencePanel;
import org.dfra.report.plot.Series;
import org.dfra.sim.world.description.WorldDescription;

/** The figures of the demonstration: paths, message sequence charts, and shame over time. */
final class RecruitCharts {

  private static final int MAP = 860; // pixels high
  private static final int SHAME = 340;
  private static final double SPARE = 1.05; // an axis is longer than its data by this factor

  private final List<String> robots;
  private final WorldDescription world;
  private final DemoTimeline timeline;
  private final List<Event> events;

  /**
   * @param robots from left to right in the charts
   * @param world of the robots
   */
  RecruitCharts(List<String> robots, WorldDescription world, DemoTimeline timeline) {
    this.robots = List.copyOf(robots);
    this.world = world;
    this.timeline = timeline;
    this.events = timeline.events();
  }

  /** The true paths of all robots, and the places of events. */
  Page map() {
    FieldMap map = new FieldMap(world, new LocalFrame(world.datum()));
    PathPanel panel = map.paths(List.of(map.ground()), timeline.trajectories());
    for (int i = 0; i < events.size(); i++) {
      panel.note(events.get(i).east(), events.get(i).north(), i + 1);
    }
    return new Page("True paths").row(MAP, panel);
  }

  /** The messages of one conversation, by sender and receiver. */
  Page chart(Attempt reported) {
    SequencePanel panel = new SequencePanel(robots);
    for (SentMessage each : reported.messages()) {
      panel.message(
          String.format(Locale.ROOT, "%.1f s", timeline.seconds(each.measured())),
          each.envelope().sender(),
          each.to(),
          text(each.envelope().message()));
    }
    return new Page(title(reported)).row(panel.height(), panel);
  }

  /** Such as {@code Call 2, by uav, after 49.9 s: attempt 1}. */
  String title(Attempt reported) {
    return String.format(
        Locale.ROOT,
        "Call %d, by %s%s, after %.1f s",
        reported.call(),
        reported.requester(),
        reported.attempt() == 1 ? "" : ", attempt " + reported.attempt(),
        timeline.seconds(reported.begun()));
  }

  /** The message type's name in the protocol. */
  private static String text(RecruitmentMessage message) {
    String name =
        message
            .getClass()
            .getSimpleName()
            .replaceAll("(?<=[a-z])(?=[A-Z])", "_")
            .toUpperCase(Locale.ROOT);
    if (message instanceof Help help) {
      return name + " " + help.call().percept();
    } else if (message instanceof Accept accept) {
      return name + " " + accept.eta().toSeconds() + " s";
    } else if (message instanceof ResponderId chosen) {
      return name + " " + chosen.winner();
    } else if (message instanceof Arrival arrival) {
      return name + " " + arrival.stay().toSeconds() + " s";
    }
    return name;
  }

  /** The shame of each robot over time. */
  Page shame() {
    double end =
        Math.max(
            1,
            timeline.statuses().values().stream()
                .flatMap(List::stream)
                .mapToDouble(each -> timeline.seconds(each.measured()))
                .max()
                .orElse(1));
    LinePanel panel =
        new LinePanel(
            "",
            Axis.of("time", "s").between(0, SPARE * end),
            Axis.of("shame", "").between(0, SPARE));
    timeline
        .statuses()
        .forEach(
            (robot, all) -> {
              if (all.stream().anyMatch(each -> each.urge() > 0)) {
                panel.add(steps(robot, all));
              }
            });
    for (int i = 0; i < events.size(); i++) {
      panel.note(events.get(i).mark().time(), i + 1);
    }
    return new Page("Shame over time").row(SHAME, panel);
  }

  private Series steps(String robot, List<RecruitmentStatus> all) {
    List<double[]> points = new ArrayList<>();
    all.forEach(each -> points.add(new double[] {timeline.seconds(each.measured()), each.urge()}));
    return Series.steps(
        robot,
        points.stream().mapToDouble(each -> each[0]).toArray(),
        points.stream().mapToDouble(each -> each[1]).toArray());
  }
}
