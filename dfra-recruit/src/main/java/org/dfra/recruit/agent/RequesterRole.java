package org.dfra.recruit.agent;

import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dfra.agent.HelpCall;
import org.dfra.agent.HelpCallRejectedException;
import org.dfra.agent.HelpCallRejectedException.Reason;
import org.dfra.agent.RequesterPhase;
import org.dfra.lease.ModuleLease;
import org.dfra.recruit.TransitionResult;
import org.dfra.recruit.message.RecruitmentMessage;
import org.dfra.recruit.requester.RequesterAction;
import org.dfra.recruit.requester.RequesterMachine;
import org.dfra.recruit.requester.RequesterState;
import org.jspecify.annotations.Nullable;

/** The requester role of an agent. It runs only inside the agent's event queue. */
final class RequesterRole {

  private final String robot;
  private final RequesterMachine machine;
  private final RecruiterPorts ports;
  private final RecruiterListener listener;
  private final MessageSender sender;
  private final Runnable giveBack;
  private final Runnable keep;
  private RequesterState state;
  private @Nullable ArrivalLease lease;
  private String replacementReason = ""; // robot that does not come after all, and why
  private String ended = "it has not called for help yet";

  /**
   * @param giveBack runs, outside of the event queue, when the lease's holder cancels it
   * @param keep runs when the state has changed
   */
  RequesterRole(
      String robot,
      RequesterMachine machine,
      RequesterState state,
      RecruiterPorts ports,
      RecruiterListener listener,
      MessageSender sender,
      Runnable giveBack,
      Runnable keep) {
    this.robot = robot;
    this.machine = machine;
    this.state = state;
    this.ports = ports;
    this.listener = listener;
    this.sender = sender;
    this.giveBack = giveBack;
    this.keep = keep;
  }

  RequesterState state() {
    return state;
  }

  boolean isUnderWay() {
    return state.phase().isUnderWay();
  }

  /** The chosen robot; null where none is. */
  @Nullable String helper() {
    return state.phase() == RequesterPhase.IDLE || state.winner() == null
        ? null
        : state.winner().robot();
  }

  Optional<ModuleLease> lease() {
    return Optional.ofNullable(lease);
  }

  /** Its state, as text. */
  String doing() {
    return switch (state.phase()) {
      case IDLE -> ended;
      case CALLING -> asking();
      case COLLECTING -> "it has an offer, and waits for further ones";
      case AWARDED -> "it has chosen " + helper() + " and waits for it";
      case ON_SITE -> helper() + " has arrived";
      case BEING_HELPED -> helper() + " helps it";
    };
  }

  private String asking() {
    if (state.round() == 0) {
      return "it waits until the previous helper confirms its release, or its lease ends";
    }
    return replacementReason.isEmpty()
        ? "it calls for help"
        : replacementReason + "; it calls again";
  }

  /** Resumes from the stored state of its last process. */
  void start() {
    if (state.phase() == RequesterPhase.BEING_HELPED || state.phase() == RequesterPhase.ON_SITE) {
      lease = new ArrivalLease(state.until(), ports.monotonicClock(), giveBack);
    }
  }

  /**
   * Calls for help.
   *
   * @throws HelpCallRejectedException if that is impossible
   */
  void call(HelpCall call) {
    refuse(call);
    replacementReason = "";
    take(machine.call(state, call, now()));
  }

  private void refuse(HelpCall call) {
    if (isUnderWay()) {
      throw new HelpCallRejectedException(
          Reason.NOT_READY,
          robot
              + " already calls for help ("
              + doing()
              + "); release that call first, or wait for its end");
    }
    if (!ports.robot().isInField(call.position())) {
      throw new HelpCallRejectedException(
          Reason.OUTSIDE_FIELD,
          String.format(
              Locale.ROOT,
              "%s cannot call for help at %.6f°, %.6f°: that is outside the field; choose a place"
                  + " inside it",
              robot,
              call.position().latitude(),
              call.position().longitude()));
    }
    if (ports.transport().capableRobots(call.percept()).isEmpty()) {
      List<String> ambiguous = ports.transport().ambiguousNames(call.percept());
      if (!ambiguous.isEmpty()) {
        throw new HelpCallRejectedException(
            Reason.AMBIGUOUS_NAMES,
            robot
                + " does not call for help to observe \""
                + call.percept()
                + "\": "
                + String.join("; ", ambiguous)
                + "; give each robot a different name in its XML");
      }
      List<String> known = ports.transport().percepts();
      throw new HelpCallRejectedException(
          known.isEmpty() ? Reason.ALONE : Reason.NO_CAPABLE_ROBOT,
          "no robot within reach of "
              + robot
              + " can observe \""
              + call.percept()
              + "\""
              + (known.isEmpty()
                  ? "; there are no other robots"
                  : "; other robots observe " + String.join(", ", known)));
    }
  }

  void release() {
    take(machine.release(state, now()));
  }

  void receive(String sender, RecruitmentMessage message) {
    take(machine.receive(state, sender, message, now()));
  }

  void tick() {
    take(machine.tick(state, now()));
  }

  private Instant now() {
    return ports.monotonicClock().instant();
  }

  private void take(TransitionResult<RequesterState, RequesterAction> step) {
    boolean isNews = !step.state().equals(state);
    state = step.state();
    if (isNews) {
      keep.run();
    }
    step.actions().forEach(this::act);
  }

  private void act(RequesterAction action) {
    listener.performed(action);
    if (action instanceof RequesterAction.SendToRobot one) {
      sender.send(one.robot(), one.message());
    } else if (action instanceof RequesterAction.SendToTeam team) {
      sender.sendToTeam(team.percept(), team.message());
    } else if (action instanceof RequesterAction.AcceptLease hold) {
      lease = new ArrivalLease(now().plus(hold.stay()), ports.monotonicClock(), giveBack);
    } else if (action instanceof RequesterAction.ReplaceHelper replace) {
      endLease();
      replacementReason = replace.robot() + " " + replace.why();
    } else if (action instanceof RequesterAction.EndCall end) {
      endLease();
      ended = "its call has ended: " + end.why();
    }
  }

  private void endLease() {
    if (lease != null) {
      lease.invalidate();
      lease = null;
    }
  }

  /**
   * The lease that a requester holds on its helper. It is not renewed: it is the time for which the
   * helper stays. Cancelling it sends a RELEASE, which may be lost; then it lasts to its end.
   */
  private static final class ArrivalLease implements ModuleLease {

    private final Instant expiration;
    private final InstantSource clock;
    private final Runnable giveBack;
    private volatile boolean isOver;

    ArrivalLease(Instant expiration, InstantSource clock, Runnable giveBack) {
      this.expiration = expiration;
      this.clock = clock;
      this.giveBack = giveBack;
    }

    @Override
    public Instant expiration() {
      return expiration;
    }

    @Override
    public boolean isLive() {
      return !isOver && clock.instant().isBefore(expiration);
    }

    /** The helper has left, or another operation releases it. */
    void invalidate() {
      isOver = true;
    }

    @Override
    public void close() {
      if (isLive()) {
        isOver = true;
        giveBack.run();
      }
    }
  }
}
