package org.dfra.examples.recruit;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.dfra.agent.RecruitmentAgent;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.agent.RequesterPhase;
import org.dfra.agent.ResponderPhase;
import org.dfra.directory.DirectoryListener;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent;
import org.dfra.event.Subscription;
import org.dfra.persona.RecruitmentAttributes;
import org.dfra.recruit.message.SentMessage;
import org.dfra.report.progress.ProgressReporter;
import org.jspecify.annotations.Nullable;

/**
 * Receives the status of a team's recruitment agents and reports it. Subscribes to agents as they
 * appear. Thread-safe.
 */
final class AgentMonitor implements AutoCloseable, DirectoryListener<RecruitmentAgent> {

  /** Queue length of each subscription, while this process is slow. */
  private static final int DEPTH = 512;

  /** Of subscribing to an agent. */
  private static final int ATTEMPTS = 5;

  private final ProgressReporter progress;
  private final Instant began;
  private volatile @Nullable DirectoryRegistration watch; // set when it starts

  @GuardedBy("this")
  private final Map<String, Subscription> subscriptions = new TreeMap<>();

  @GuardedBy("this")
  private final Map<String, List<RecruitmentStatus>> received = new TreeMap<>();

  @GuardedBy("this")
  private final List<SentMessage> envelopes = new ArrayList<>();

  @GuardedBy("this")
  private final List<OperatorEvent> noted = new ArrayList<>();

  // by robot
  @GuardedBy("this")
  private final Map<String, Instant> deaths = new TreeMap<>();

  // robots
  @GuardedBy("this")
  private final Set<String> cutOff = new TreeSet<>();

  @GuardedBy("this")
  private boolean isOver;

  /** An event of a robot that its agent does not publish. */
  record OperatorEvent(Instant time, String robot, String what) {}

  private AgentMonitor(ProgressReporter progress, Instant began) {
    this.progress = progress;
    this.began = began;
  }

  /**
   * Subscribes to agents as they appear.
   *
   * @param began the robots' time to which reported seconds are relative
   */
  static AgentMonitor start(ModuleDirectory directory, ProgressReporter progress, Instant began) {
    AgentMonitor monitor = new AgentMonitor(progress, began);
    monitor.watch = directory.listen(ModuleQuery.of(RecruitmentAgent.class), monitor);
    return monitor;
  }

  /** Subscribes without the lock, since the deliveries of other agents need it meanwhile. */
  @Override
  public void matched(ModuleListing<RecruitmentAgent> listing) {
    String robot = listing.robot();
    if (!isNew(robot)) {
      return; // its subscription registers itself again
    }
    try {
      Subscription subscription = subscribe(listing);
      if (!add(robot, subscription)) {
        subscription.close();
        return;
      }
      List<String> percepts =
          listing.attributes(RecruitmentAttributes.class).stream()
              .flatMap(each -> each.percepts().stream())
              .toList();
      progress.say(
          "%s appears: its agent %s.",
          robot,
          percepts.isEmpty() ? "only requests help" : "can observe " + String.join(", ", percepts));
    } catch (RemoteException e) {
      progress.say(
          "%s appears, but its events cannot be received: %s",
          robot, String.valueOf(e.getMessage()));
    }
  }

  private synchronized boolean isNew(String robot) {
    return !isOver && !subscriptions.containsKey(robot);
  }

  /** Keeps a subscription; false if it is not needed any more. */
  private synchronized boolean add(String robot, Subscription subscription) {
    return !isOver && subscriptions.putIfAbsent(robot, subscription) == null;
  }

  /** Tries it again if there is no answer in time: five robots that start keep a computer busy. */
  private Subscription subscribe(ModuleListing<RecruitmentAgent> listing) throws RemoteException {
    for (int attempt = 1; ; attempt++) {
      try {
        return listing
            .module()
            .subscribe(
                delivery -> received(listing.robot(), delivery), DeliveryPolicy.keepLast(DEPTH));
      } catch (RemoteException e) {
        if (attempt == ATTEMPTS) {
          throw e;
        }
      }
    }
  }

  private synchronized void received(String robot, Delivery delivery) {
    if (isOver || !(delivery.event() instanceof ModuleEvent.NewReading fresh)) {
      return;
    }
    if (fresh.reading() instanceof SentMessage sent) {
      envelopes.add(sent);
    } else if (fresh.reading() instanceof RecruitmentStatus status) {
      List<RecruitmentStatus> all = received.computeIfAbsent(robot, name -> new ArrayList<>());
      say(robot, all.isEmpty() ? null : last(all), status);
      all.add(status);
    }
  }

  private void say(String robot, @Nullable RecruitmentStatus last, RecruitmentStatus now) {
    boolean isSilent =
        now.requesterPhase() == RequesterPhase.IDLE && now.responderPhase() == ResponderPhase.FREE;
    boolean isNews =
        last == null
            ? !isSilent
            : last.requesterPhase() != now.requesterPhase()
                || last.responderPhase() != now.responderPhase();
    if (isNews) {
      progress.say("%s: %s (%s).", moment(robot, now), phases(last, now), now.lastChange());
    } else if (isSilent && now.urge() > (last == null ? 0 : last.urge())) {
      progress.say(
          "%s: it has received the call and does not respond; its shame is %.2f.",
          moment(robot, now), now.urge());
    }
  }

  /** The robot's name, and the time on the robots' clock. */
  private String moment(String robot, RecruitmentStatus now) {
    double seconds = Duration.between(began, now.measured()).toMillis() / 1000.0;
    return String.format(Locale.ROOT, "%s, after %.0f s", robot, seconds);
  }

  /** The phases that differ from before. */
  private static String phases(@Nullable RecruitmentStatus last, RecruitmentStatus now) {
    List<String> phases = new ArrayList<>();
    if (now.requesterPhase() != (last == null ? RequesterPhase.IDLE : last.requesterPhase())) {
      phases.add(now.requesterPhase().toString());
    }
    if (now.responderPhase() != (last == null ? ResponderPhase.FREE : last.responderPhase())) {
      phases.add(now.responderPhase().toString());
    }
    return String.join(" and ", phases);
  }

  /** Records an event of a robot now. */
  synchronized void note(Instant now, String robot, String what) {
    noted.add(new OperatorEvent(now, robot, what));
  }

  /** Records that a robot dies now: from here on it helps no robot, whatever its last status. */
  synchronized void noteDeath(Instant now, String robot, String what) {
    note(now, robot, what);
    deaths.put(robot, now);
  }

  /** Records whether a robot's agent can be reached from now on. */
  synchronized void noteReachable(Instant now, String robot, boolean canBe) {
    if (canBe) {
      cutOff.remove(robot);
      note(now, robot, "can be reached again");
    } else {
      cutOff.add(robot);
      note(now, robot, "receives and sends nothing from now on");
    }
  }

  /** Whether the robot's death was recorded. */
  synchronized boolean isDead(String robot) {
    return deaths.containsKey(robot);
  }

  /** Whether the robot is recorded as unreachable for now. */
  synchronized boolean isCutOff(String robot) {
    return cutOff.contains(robot);
  }

  /** The recorded events in order of time. */
  synchronized List<OperatorEvent> noted() {
    return List.copyOf(noted);
  }

  /** Robots whose agents have been subscribed to. */
  synchronized Set<String> listening() {
    return Set.copyOf(subscriptions.keySet());
  }

  /** The robot that is committed to help, and not one of those. */
  synchronized Optional<String> committed(Set<String> others) {
    return received.entrySet().stream()
        .filter(each -> !others.contains(each.getKey()))
        .filter(each -> last(each.getValue()).responderPhase().isCommitted())
        .map(Map.Entry::getKey)
        .findFirst();
  }

  /** Robots that were committed to help at some time. */
  synchronized Set<String> helpers() {
    return received.entrySet().stream()
        .filter(
            each ->
                each.getValue().stream()
                    .anyMatch(reported -> reported.responderPhase().isCommitted()))
        .map(Map.Entry::getKey)
        .collect(Collectors.toSet());
  }

  /** The last status of that robot; empty if there is none. */
  synchronized Optional<RecruitmentStatus> last(String robot) {
    return Optional.ofNullable(received.get(robot)).map(AgentMonitor::last);
  }

  private static RecruitmentStatus last(List<RecruitmentStatus> all) {
    return all.get(all.size() - 1);
  }

  /** All statuses by robot, in the order received. */
  synchronized Map<String, List<RecruitmentStatus>> statuses() {
    Map<String, List<RecruitmentStatus>> copy = new TreeMap<>();
    received.forEach((robot, all) -> copy.put(robot, List.copyOf(all)));
    return copy;
  }

  /** All messages that agents sent, in the order reported. */
  synchronized List<SentMessage> messages() {
    return List.copyOf(envelopes);
  }

  /** For how many seconds of the robots' time two helped at once, by the time stamps of each. */
  synchronized double overlapSeconds() {
    return overlapSeconds(received, deaths);
  }

  /** Interval during which a robot was committed to help. */
  private record Span(String robot, Instant from, Instant to) {

    /** Until a time, or until the robot died before it. */
    static Span of(String robot, Instant from, Instant to, @Nullable Instant death) {
      Instant end = death != null && death.isAfter(from) && death.isBefore(to) ? death : to;
      return new Span(robot, from, end);
    }
  }

  /**
   * The same from statuses, by robot. A robot that did not report the end of its help is taken to
   * have helped until the last status of any robot. One that died helped until then, also if its
   * agent was started again and reports later that it is free.
   *
   * @param deaths when a robot died, by robot
   */
  static double overlapSeconds(
      Map<String, List<RecruitmentStatus>> reported, Map<String, Instant> deaths) {
    Instant last =
        reported.values().stream()
            .flatMap(List::stream)
            .map(RecruitmentStatus::measured)
            .max(Comparator.naturalOrder())
            .orElse(Instant.MIN);
    List<Span> spans = new ArrayList<>();
    reported.forEach(
        (robot, all) -> {
          @Nullable Instant death = deaths.get(robot);
          @Nullable Instant from = null;
          for (RecruitmentStatus each : all) {
            if (each.responderPhase().isCommitted() && from == null) {
              from = each.measured();
            } else if (!each.responderPhase().isCommitted() && from != null) {
              spans.add(Span.of(robot, from, each.measured(), death));
              from = null;
            }
          }
          if (from != null) {
            spans.add(Span.of(robot, from, last, death));
          }
        });
    double seconds = 0;
    for (Span one : spans) {
      for (Span other : spans) {
        if (one.robot().compareTo(other.robot()) < 0) {
          Instant from = one.from().isAfter(other.from()) ? one.from() : other.from();
          Instant to = one.to().isBefore(other.to()) ? one.to() : other.to();
          seconds += Math.max(0, Duration.between(from, to).toMillis() / 1000.0);
        }
      }
    }
    return seconds;
  }

  @Override
  public void close() {
    DirectoryRegistration watching = watch;
    if (watching != null) {
      watching.close();
    }
    List<Subscription> ending;
    synchronized (this) {
      isOver = true;
      ending = List.copyOf(subscriptions.values());
    }
    ending.forEach(Subscription::close);
  }
}
