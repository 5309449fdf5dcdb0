package org.dfra.recruit.agent;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Supplier;
import org.dfra.agent.HelpCall;
import org.dfra.agent.HelpCallRejectedException;
import org.dfra.agent.HelpCallRejectedException.Reason;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.agent.RequesterPhase;
import org.dfra.agent.ResponderPhase;
import org.dfra.lease.ModuleLease;
import org.dfra.recruit.RecruitmentSettings;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.message.MessageEnvelope;
import org.dfra.recruit.message.RecruitmentMessage;
import org.dfra.recruit.requester.RequesterMachine;
import org.dfra.recruit.requester.RequesterState;
import org.dfra.recruit.strategy.RecruitmentStrategy;
import org.dfra.recruit.transport.Transport.MessageMode;
import org.dfra.time.Scheduler.ScheduledTask;
import org.jspecify.annotations.Nullable;

/**
 * The agent of one robot: it calls other robots for help, and helps. A timer wakes it when a
 * timeout of one of its two state machines is due.
 *
 * <p>Thread-safe: it processes one event after the other. It calls its ports while processing;
 * these neither block nor call back before they return.
 */
public final class Recruiter implements AutoCloseable {

  /** Minimum delay of a wake-up after a failure: the same failure may recur at once. */
  private static final Duration RECOVERY = Duration.ofSeconds(1);

  private final String robot;
  private final RecruiterPorts ports;
  private final RecruitmentStrategy strategy;
  private final RecruiterListener listener;
  private final RequesterRole caller;
  private final ResponderRole helper;
  private final WakeTimer alarm;

  private final RunToCompletionQueue turns = new RunToCompletionQueue();
  private boolean isOver; // changed only inside the event queue
  private String doing; // likewise; the last published status
  private String callersNews; // likewise
  private String helpersNews; // likewise
  private volatile RecruitmentStatus status;

  /**
   * @param robot its name, to which others send
   * @param strategy its own, not shared
   * @param kept state of its last process; empty for a fresh start
   */
  public Recruiter(
      String robot,
      RecruitmentSettings settings,
      RecruitmentStrategy strategy,
      MessageMode mode,
      RecruiterPorts ports,
      RecruiterListener listener,
      Optional<AgentSnapshot> kept) {
    this.robot = robot;
    this.ports = ports;
    this.strategy = strategy;
    this.listener = listener;
    this.alarm = new WakeTimer(ports, this::wake);
    MessageSender sender = new MessageSender(robot, mode, ports, listener);
    Runnable keep = () -> listener.snapshotChanged(kept());
    this.caller =
        new RequesterRole(
            robot,
            new RequesterMachine(settings, strategy),
            kept.map(AgentSnapshot::requester)
                .orElseGet(
                    () -> // greater than any number of an earlier process without a stored state
                    RequesterState.idle(new Conversation(robot, ports.monotonicClock().millis()))),
            ports,
            listener,
            sender,
            this::release,
            keep);
    this.helper =
        new ResponderRole(
            robot,
            settings,
            strategy,
            ports,
            listener,
            this::post,
            sender::send,
            caller::isUnderWay,
            keep);
    kept.ifPresent(
        snapshot -> {
          helper.restore(snapshot.responder());
          strategy.restore(snapshot.urge());
        });
    this.callersNews = caller.doing();
    this.helpersNews = helper.doing();
    this.doing = helpersNews;
    this.status = currentStatus();
  }

  /** Resumes from the stored state of its last process. */
  public void start() {
    turns.run(
        () -> {
          caller.start();
          helper.start();
          afterwards(Instant.MIN);
        });
  }

  /** Stops sending. Its helper or requester detects this by leases and timeouts. */
  @Override
  public void close() {
    turns.run(
        () -> {
          isOver = true;
          alarm.set(Instant.MAX);
        });
  }

  /**
   * Calls for help.
   *
   * @throws HelpCallRejectedException as specified there
   */
  public void help(HelpCall call) {
    turns.run(
        () -> {
          if (isOver) {
            throw new HelpCallRejectedException(
                Reason.NOT_READY,
                robot + "'s agent has ended; call again when it has been restarted");
          }
          handle(() -> caller.call(call));
        });
  }

  /** Cancels the call and releases the helper. */
  public void release() {
    post(caller::release);
  }

  /** Handles a message from another agent. */
  public void receive(MessageEnvelope envelope) {
    post(
        () -> {
          listener.received(envelope);
          RecruitmentMessage message = envelope.message();
          if (message.conversation().requester().equals(robot)) {
            caller.receive(envelope.sender(), message);
          } else if (message.conversation().requester().equals(envelope.sender())) {
            helper.receive(message);
          } // otherwise the sender's name is forged
        });
  }

  /** Checks its robot, and publishes the start or end of a hold. */
  public void refresh() {
    post(() -> {});
  }

  /** The lease on the helper; empty where there is none. */
  public Optional<ModuleLease> lease() {
    return turns.query(caller::lease);
  }

  /** Its status. */
  public RecruitmentStatus status() {
    return status;
  }

  /** Its state to store for the next process. */
  public AgentSnapshot snapshot() {
    return turns.query(this::kept);
  }

  private AgentSnapshot kept() {
    return new AgentSnapshot(caller.state(), helper.state(), strategy.urge());
  }

  private void post(Runnable event) {
    turns.run(
        () -> {
          if (!isOver) {
            handle(event);
          }
        });
  }

  private void handle(Runnable event) {
    Instant notBefore = ports.monotonicClock().instant().plus(RECOVERY);
    try {
      event.run();
      notBefore = Instant.MIN;
    } catch (HelpCallRejectedException e) { // no change
      notBefore = Instant.MIN;
      throw e;
    } finally { // even if a custom strategy has failed
      afterwards(notBefore);
    }
  }

  /** After each event: sets the timer and publishes the status. */
  private void afterwards(Instant notBefore) {
    Instant wanted = caller.state().nextWake();
    Instant helping = helper.state().nextWake();
    Instant due = wanted.isBefore(helping) ? wanted : helping;
    alarm.set(isOver ? Instant.MAX : due.isBefore(notBefore) ? notBefore : due);
    if (!caller.doing().equals(callersNews)) {
      callersNews = caller.doing();
      doing = callersNews;
    }
    if (!helper.doing().equals(helpersNews)) {
      helpersNews = helper.doing();
      doing = helpersNews;
    }
    RecruitmentStatus fresh = currentStatus();
    RecruitmentStatus last = status;
    status = fresh;
    if (fresh.urge() != last.urge()) {
      listener.snapshotChanged(kept()); // it may have changed after the state was stored
    }
    if (fresh.requesterPhase() != last.requesterPhase()
        || fresh.responderPhase() != last.responderPhase()
        || fresh.urge() != last.urge()
        || !Objects.equals(fresh.holdReason(), last.holdReason())) {
      listener.statusChanged(fresh);
    }
  }

  private void wake() {
    post(
        () -> {
          alarm.fired();
          try {
            caller.tick();
          } finally { // a timeout frees a helper, independently of its own call
            helper.tick();
          }
        });
  }

  private RecruitmentStatus currentStatus() {
    return new RecruitmentStatus(
        ports.clock().instant(),
        caller.state().phase(),
        caller.helper(),
        helper.state().phase(),
        helper.requester(),
        strategy.urge(),
        helper.state().phase() != ResponderPhase.FREE
            ? helper.doing()
            : caller.state().phase() != RequesterPhase.IDLE ? caller.doing() : doing,
        ports.robot().holdReason().orElse(null));
  }

  @Override
  public String toString() {
    return "agent of " + robot;
  }

  /**
   * Wakes an agent at one future time. Except for the wake-up, it runs only inside the agent's
   * event queue.
   */
  private static final class WakeTimer {

    private final RecruiterPorts ports;
    private final Runnable wake;
    private @Nullable ScheduledTask task;
    private Instant at = Instant.MAX;

    WakeTimer(RecruiterPorts ports, Runnable wake) {
      this.ports = ports;
      this.wake = wake;
    }

    /** Sets the time; {@link Instant#MAX} means never. */
    void set(Instant then) {
      if (then.equals(at)) {
        return;
      }
      if (task != null) {
        task.cancel();
      }
      at = then;
      task =
          then.equals(Instant.MAX)
              ? null
              : ports
                  .scheduler()
                  .after(Duration.between(ports.monotonicClock().instant(), then).toNanos(), wake);
    }

    /**
     * Handles the wake-up; if it was early by the clock, the timer is set to the same time again.
     */
    void fired() {
      task = null;
      at = Instant.MAX;
    }
  }

  /**
   * Runs one event after the other. An event submitted by the running event, such as the end of a
   * lease that it cancels, runs next.
   */
  private static final class RunToCompletionQueue {

    @GuardedBy("this")
    private final ArrayDeque<Runnable> waiting = new ArrayDeque<>();

    @GuardedBy("this")
    private boolean isTaken;

    /** Runs an event before this returns, unless the running event calls it. */
    synchronized void run(Runnable turn) {
      waiting.add(turn);
      if (isTaken) {
        return;
      }
      isTaken = true;
      @Nullable RuntimeException failure = null;
      try {
        for (Runnable next = waiting.poll(); next != null; next = waiting.poll()) {
          try {
            next.run();
          } catch (RuntimeException e) { // events submitted meanwhile must run nevertheless
            failure = failure == null ? e : failure;
          }
        }
      } finally {
        isTaken = false;
      }
      if (failure != null) {
        throw failure;
      }
    }

    /** Reads state between two events. */
    synchronized <T> T query(Supplier<T> look) {
      return look.get();
    }
  }
}
