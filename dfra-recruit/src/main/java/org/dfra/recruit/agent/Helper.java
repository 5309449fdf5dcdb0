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
import org.dfra.core.lease.Grant;
import org.dfra.lease.Holder;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.recruit.RecruitmentSettings;
import org.dfra.recruit.Step;
import org.dfra.recruit.affect.Stimulus;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.message.RecruitmentMessage;
import org.dfra.recruit.message.RecruitmentMessage.Help;
import org.dfra.recruit.responder.Judge;
import org.dfra.recruit.responder.ResponderAction;
import org.dfra.recruit.responder.ResponderMachine;
import org.dfra.recruit.responder.ResponderState;
import org.dfra.recruit.strategy.RecruitmentStrategy;
import org.jspecify.annotations.Nullable;

/** The half of an agent that helps others. Everything happens in the agent's turns. */
final class Helper implements Judge {

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
  private String freed = "it helps nobody";

  Helper(
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

  /** What it is at, in words. */
  String doing() {
    return switch (state.phase()) {
      case FREE -> freed;
      case OFFERED -> "it has offered to help " + helped();
      case TRAVELLING -> "it is on its way to help " + helped();
      case ARRIVED -> "it is there to help " + helped();
      case LEASED -> "it observes for " + helped();
    };
  }

  /** The robot that it helps, or has offered to. */
  @Nullable String helped() {
    Conversation in = state.conversation();
    return in == null ? null : in.requester();
  }

  void restore(ResponderState kept) {
    state = kept;
  }

  /**
   * Goes on with what it was at when its process died. One that helps nobody may have died after it
   * was freed and before its robot went on with its work: the robot is told once more.
   */
  void start() {
    if (!state.phase().isCommitted()) {
      ports.body().resume();
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
      state = state.leasedAs(grant(state.stay(now())));
      if (state.phase() == ResponderPhase.LEASED) {
        ports.body().observe(call);
      }
    } catch (LeaseRefusedException e) {
      take(machine.unable(state, String.valueOf(e.getMessage())));
    }
  }

  void hear(RecruitmentMessage message) {
    take(machine.hear(state, message, now()));
  }

  void tick() {
    take(machine.tick(state, now()));
  }

  @Override
  public Optional<Offer> offer(HelpCall call) {
    Body body = ports.body();
    boolean isAble =
        body.isFree()
            && !needsHelpItself.getAsBoolean()
            && body.canObserve(call.percept())
            && body.isInField(call.place());
    return isAble
        ? body.eta(call.place())
            .filter(eta -> eta.compareTo(HelpCall.LONGEST) <= 0)
            .map(eta -> new Offer(eta, body.battery()))
        : Optional.empty();
  }

  @Override
  public boolean accepts(Help help, Offer offer) {
    return strategy.answers(
        new Stimulus(
            help.conversation(), offer.eta(), offer.battery(), ports.body().isBusy(), now()));
  }

  @Override
  public boolean refusesAloud() {
    return strategy.refusesAloud();
  }

  private Instant now() {
    return ports.steady().instant();
  }

  private void take(Step<ResponderState, ResponderAction> step) {
    boolean isNews = !step.state().equals(state);
    state = step.state();
    if (isNews) {
      keep.run();
    }
    step.actions().forEach(this::act);
  }

  private void act(ResponderAction action) {
    listener.did(action);
    if (action instanceof ResponderAction.ToOne one) {
      send.accept(one.robot(), one.message());
    } else if (action instanceof ResponderAction.Go go) {
      setOut(go.call(), go.until());
    } else if (action instanceof ResponderAction.Extend extend) {
      ports.body().extend(nanos(extend.until()));
    } else if (action instanceof ResponderAction.Observe observe) {
      ports.body().observe(observe.call());
    } else if (action instanceof ResponderAction.Resume resume) {
      freed = "it is free again: " + resume.why();
      ports.body().resume();
    } else if (action instanceof ResponderAction.EndLease end) {
      boolean unused = ports.leases().cancel(end.lease());
    } else if (action instanceof ResponderAction.Atone) {
      strategy.chosen();
    } else if (action instanceof ResponderAction.Relieve) {
      strategy.spared();
    }
  }

  private void setOut(HelpCall call, Instant until) {
    Conversation in = state.conversation();
    ports
        .body()
        .go(
            call,
            nanos(until),
            new Body.Journey() {
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
   * The same time by the scheduler. That is read before the clock: a process that is suspended
   * between the two makes the lease shorter, never longer.
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
      take(machine.unable(state, why));
    }
  }

  private void atPlace(@Nullable Conversation in) {
    HelpCall call = state.call();
    if (!isTravelling(in) || call == null) {
      return;
    }
    Duration longest = ports.leases().terms().longest();
    Duration stay = call.stay().compareTo(longest) < 0 ? call.stay() : longest;
    try {
      UUID lease = grant(stay);
      take(machine.arrived(state, lease, stay, now()));
    } catch (LeaseRefusedException e) {
      take(machine.unable(state, String.valueOf(e.getMessage())));
    }
  }

  private UUID grant(Duration stay) throws LeaseRefusedException {
    Over over = new Over();
    Grant grant = ports.leases().grant(stay, Holder.CLIENT, null, () -> turns.accept(over::run));
    over.id = grant.id();
    return grant.id();
  }

  /** The end of a lease that its holder did not give back. */
  private final class Over {
    @Nullable UUID id; // set in the turn in which it is granted

    /**
     * What ends before its time and was not revoked ended with the module, or by a time that goes
     * faster than the robot's: what was promised holds on, for the next process or until its end.
     */
    void run() {
      UUID ended = id;
      if (ended == null) {
        return;
      }
      boolean isDue = state.stay(now()).compareTo(settings.margin()) <= 0;
      if (isDue || ports.leases().isRevoked(ended)) {
        take(machine.leaseOver(state, ended, now()));
      }
    }
  }
}
