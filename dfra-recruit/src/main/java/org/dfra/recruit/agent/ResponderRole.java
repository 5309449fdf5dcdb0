package org.dfra.recruit.agent;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.UUID;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.dfra.agent.HelpCall;
import org.dfra.agent.ResponderPhase;
import org.dfra.core.lease.LeaseRegistry.LeaseGrant;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.LeaseRole;
import org.dfra.recruit.RecruitmentSettings;
import org.dfra.recruit.TransitionResult;
import org.dfra.recruit.affect.Stimulus;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.message.RecruitmentMessage;
import org.dfra.recruit.message.RecruitmentMessage.Help;
import org.dfra.recruit.responder.ResponderAction;
import org.dfra.recruit.responder.ResponderMachine;
import org.dfra.recruit.responder.ResponderMachine.ResponderPolicy;
import org.dfra.recruit.responder.ResponderState;
import org.dfra.recruit.strategy.RecruitmentStrategy;
import org.jspecify.annotations.Nullable;

/** The responder role of an agent. It runs only inside the agent's event queue. */
final class ResponderRole implements ResponderPolicy {

  private static final Duration FOREVER = Duration.ofDays(10_000);

  private final RecruitmentSettings settings;
  private final RecruitmentStrategy strategy;
  private final RecruiterPorts ports;
  private final RecruiterListener listener;
  private final Consumer<Runnable> turns;
  private final BiConsumer<String, RecruitmentMessage> send;
  private final BooleanSupplier needsHelpItself;
  private final ResponderMachine machine;
  private final Runnable keep;
  private ResponderState state = ResponderState.FREE;
  private String freed = "it is not helping";

  ResponderRole(
      String robot,
      RecruitmentSettings settings,
      RecruitmentStrategy strategy,
      RecruiterPorts ports,
      RecruiterListener listener,
      Consumer<Runnable> turns,
      BiConsumer<String, RecruitmentMessage> send,
      BooleanSupplier needsHelpItself,
      Runnable keep) {
    this.settings = settings;
    this.strategy = strategy;
    this.ports = ports;
    this.listener = listener;
    this.turns = turns;
    this.send = send;
    this.needsHelpItself = needsHelpItself;
    this.keep = keep;
    this.machine = new ResponderMachine(robot, settings, this);
  }

  ResponderState state() {
    return state;
  }

  /** Its state, as text. */
  String doing() {
    return switch (state.phase()) {
      case FREE -> freed;
      case OFFERED -> "it has offered to help " + requester();
      case TRAVELLING -> "it is on its way to help " + requester();
      case ARRIVED -> "it has arrived to help " + requester();
      case LEASED -> "it observes for " + requester();
    };
  }

  /** The robot that it helps, or has offered help. */
  @Nullable String requester() {
    Conversation in = state.conversation();
    return in == null ? null : in.requester();
  }

  void restore(ResponderState kept) {
    state = kept;
  }

  /**
   * Resumes from the stored state of its last process. An idle agent may have crashed after its
   * release and before its robot resumed its work: so it repeats that command.
   */
  void start() {
    if (!state.phase().isCommitted()) {
      ports.robot().resumeOwnWork();
    }
    tick();
    HelpCall call = state.call();
    if (call == null) {
      return;
    }
    if (state.phase() == ResponderPhase.TRAVELLING) {
      setOut(call, state.until());
    } else if (state.phase().isCommitted()) {
      stayOn(call);
    }
  }

  private void stayOn(HelpCall call) {
    try {
      state = state.withLease(grant(state.remainingStay(now())));
      if (state.phase() == ResponderPhase.LEASED) {
        ports.robot().observe(call);
      }
    } catch (LeaseRefusedException e) {
      take(machine.abort(state, String.valueOf(e.getMessage())));
    }
  }

  void receive(RecruitmentMessage message) {
    take(machine.receive(state, message, now()));
  }

  void tick() {
    take(machine.tick(state, now()));
  }

  @Override
  public Optional<Offer> offer(HelpCall call) {
    RobotPort body = ports.robot();
    boolean isAble =
        body.isAvailable()
            && !needsHelpItself.getAsBoolean()
            && body.canObserve(call.percept())
            && body.isInField(call.position());
    return isAble
        ? body.eta(call.position())
            .filter(eta -> eta.compareTo(HelpCall.MAX_DURATION) <= 0)
            .map(eta -> new Offer(eta, body.battery()))
        : Optional.empty();
  }

  @Override
  public boolean shouldOffer(Help help, Offer offer) {
    return strategy.shouldOffer(
        new Stimulus(
            help.conversation(), offer.eta(), offer.battery(), ports.robot().hasOwnWork(), now()));
  }

  @Override
  public boolean sendsRefusal() {
    return strategy.sendsRefusal();
  }

  private Instant now() {
    return ports.monotonicClock().instant();
  }

  private void take(TransitionResult<ResponderState, ResponderAction> step) {
    boolean isNews = !step.state().equals(state);
    state = step.state();
    if (isNews) {
      keep.run();
    }
    step.actions().forEach(this::act);
  }

  private void act(ResponderAction action) {
    listener.performed(action);
    if (action instanceof ResponderAction.SendToRobot one) {
      send.accept(one.robot(), one.message());
    } else if (action instanceof ResponderAction.TravelTo go) {
      setOut(go.call(), go.until());
    } else if (action instanceof ResponderAction.ExtendLease extend) {
      ports.robot().extendLease(nanos(extend.until()));
    } else if (action instanceof ResponderAction.Observe observe) {
      ports.robot().observe(observe.call());
    } else if (action instanceof ResponderAction.ResumeOwnWork resume) {
      freed = "it is free again: " + resume.why();
      ports.robot().resumeOwnWork();
    } else if (action instanceof ResponderAction.EndLease end) {
      boolean unused = ports.leases().cancel(end.lease());
    } else if (action instanceof ResponderAction.ResetOnHelping) {
      strategy.onChosen();
    } else if (action instanceof ResponderAction.ResetOnRelease) {
      strategy.onNotChosen();
    }
  }

  private void setOut(HelpCall call, Instant until) {
    Conversation in = state.conversation();
    ports
        .robot()
        .travelTo(
            call,
            nanos(until),
            new RobotPort.TravelListener() {
              @Override
              public void arrived() {
                turns.accept(() -> atPlace(in));
              }

              @Override
              public void failed(String why) {
                turns.accept(() -> strayed(in, why));
              }
            });
  }

  /**
   * Converts a time to the scheduler's time. It reads the scheduler before the clock: a suspension
   * of the process in between shortens the lease, never lengthens it.
   */
  private long nanos(Instant until) {
    long now = ports.scheduler().nanos();
    Duration left = Duration.between(now(), until);
    return left.compareTo(FOREVER) < 0 ? now + left.toNanos() : Long.MAX_VALUE;
  }

  private boolean isTravelling(@Nullable Conversation in) {
    return state.phase() == ResponderPhase.TRAVELLING
        && in != null
        && in.equals(state.conversation());
  }

  private void strayed(@Nullable Conversation in, String why) {
    if (isTravelling(in)) {
      take(machine.abort(state, why));
    }
  }

  private void atPlace(@Nullable Conversation in) {
    HelpCall call = state.call();
    if (!isTravelling(in) || call == null) {
      return;
    }
    Duration longest = ports.leases().terms().maxDuration();
    Duration stay = call.stayDuration().compareTo(longest) < 0 ? call.stayDuration() : longest;
    try {
      UUID lease = grant(stay);
      take(machine.arrived(state, lease, stay, now()));
    } catch (LeaseRefusedException e) {
      take(machine.abort(state, String.valueOf(e.getMessage())));
    }
  }

  private UUID grant(Duration stay) throws LeaseRefusedException {
    LeaseEndListener over = new LeaseEndListener();
    LeaseGrant grant =
        ports.leases().grant(stay, LeaseRole.CLIENT, null, () -> turns.accept(over::run));
    over.id = grant.id();
    return grant.id();
  }

  /** The end of a lease that its holder did not cancel. */
  private final class LeaseEndListener {
    @Nullable UUID id; // set while the event that grants it is processed

    /**
     * A lease that ends early without a revocation ended with the module, or by a clock faster than
     * the robot's: the promise stays valid, for the next process or until its end.
     */
    void run() {
      UUID ended = id;
      if (ended == null) {
        return;
      }
      boolean isDue = state.remainingStay(now()).compareTo(settings.margin()) <= 0;
      if (isDue || ports.leases().isRevoked(ended)) {
        take(machine.leaseEnded(state, ended, now()));
      }
    }
  }
}
