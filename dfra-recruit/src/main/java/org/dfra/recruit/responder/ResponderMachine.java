package org.dfra.recruit.responder;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import org.dfra.agent.HelpCall;
import org.dfra.agent.ResponderPhase;
import org.dfra.recruit.RecruitmentSettings;
import org.dfra.recruit.Step;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.message.RecruitmentMessage;
import org.dfra.recruit.message.RecruitmentMessage.Accept;
import org.dfra.recruit.message.RecruitmentMessage.AckAck;
import org.dfra.recruit.message.RecruitmentMessage.Agree;
import org.dfra.recruit.message.RecruitmentMessage.Arrival;
import org.dfra.recruit.message.RecruitmentMessage.Help;
import org.dfra.recruit.message.RecruitmentMessage.Refuse;
import org.dfra.recruit.message.RecruitmentMessage.Release;
import org.dfra.recruit.message.RecruitmentMessage.ResponderId;
import org.dfra.recruit.responder.Judge.Offer;
import org.dfra.recruit.responder.ResponderAction.Atone;
import org.dfra.recruit.responder.ResponderAction.EndLease;
import org.dfra.recruit.responder.ResponderAction.Extend;
import org.dfra.recruit.responder.ResponderAction.Go;
import org.dfra.recruit.responder.ResponderAction.Observe;
import org.dfra.recruit.responder.ResponderAction.Relieve;
import org.dfra.recruit.responder.ResponderAction.Resume;
import org.dfra.recruit.responder.ResponderAction.ToOne;

/**
 * Moves who may help along the arrows of {@link ResponderPhase}. Pure but for what it asks its
 * {@link Judge}: each method gives the next state and what is to be done, and changes nothing.
 * Whatever is lost, comes late, twice or in another order:
 *
 * <ul>
 *   <li>It is free again in the end: every state but {@code FREE} has a time at which it is left.
 *   <li>Once it has left a conversation it has no part in it any more; who chooses it there is
 *       refused, and who agrees with it once more hears ACK_ACK once more.
 *   <li>A message of a newer conversation of the same requester frees it from the older one.
 * </ul>
 */
public final class ResponderMachine {

  private final String robot;
  private final RecruitmentSettings settings;
  private final Judge judge;

  /**
   * @param robot its own name
   */
  public ResponderMachine(String robot, RecruitmentSettings settings, Judge judge) {
    this.robot = robot;
    this.settings = settings;
    this.judge = judge;
  }

  /** A requester has sent a message. One that is not to a responder is left alone. */
  public Step<ResponderState, ResponderAction> hear(
      ResponderState before, RecruitmentMessage message, Instant now) {
    List<ResponderAction> actions = new ArrayList<>();
    ResponderState state = taken(tick(before, now), actions);
    if (isToResponders(message)) {
      Conversation mine = state.conversation();
      if (mine != null && message.conversation().supersedes(mine)) {
        state = taken(free(state, "the call goes on without it"), actions);
      }
      state = taken(hearNow(state, message, now), actions);
    }
    return new Step<>(state, actions);
  }

  private static boolean isToResponders(RecruitmentMessage message) {
    return message instanceof Help
        || message instanceof ResponderId
        || message instanceof Agree
        || message instanceof Release;
  }

  private static ResponderState taken(
      Step<ResponderState, ResponderAction> step, List<ResponderAction> actions) {
    actions.addAll(step.actions());
    return step.state();
  }

  private Step<ResponderState, ResponderAction> hearNow(
      ResponderState state, RecruitmentMessage message, Instant now) {
    if (message instanceof Help help) {
      return help(state, help, now);
    }
    if (message instanceof ResponderId id) {
      return id.winner().equals(robot) ? chosen(state, id, now) : passedOver(state, id);
    }
    if (message instanceof Agree agree) {
      return agreed(state, agree.conversation());
    }
    return released(state, (Release) message);
  }

  private Step<ResponderState, ResponderAction> help(
      ResponderState before, Help help, Instant now) {
    Conversation asked = help.conversation();
    Ledger ledger = before.ledger(asked);
    if (ledger.hasHeard(asked.number(), help.round())) {
      return Step.none(before);
    }
    ResponderState state =
        before.remember(asked.requester(), ledger.hear(asked.number(), help.round()));
    if (state.isIn(asked)) { // the offer was lost, or is still on its way
      return state.phase() == ResponderPhase.OFFERED ? offerAgain(state, 1, now) : Step.none(state);
    }
    boolean isOver = asked.number() <= ledger.closed();
    if (isOver || state.phase() != ResponderPhase.FREE) {
      String why = isOver ? "it is out of this" : "it helps another";
      return declined(state, new Refuse(asked, why, isOver));
    }
    Optional<Offer> offer = judge.offer(help.call());
    return offer.isPresent() && judge.accepts(help, offer.get())
        ? offer(state, asked, help.call(), offer.get(), 1, now)
        : declined(state, new Refuse(asked, "it cannot or does not want to", false));
  }

  private Step<ResponderState, ResponderAction> declined(ResponderState state, Refuse aloud) {
    return judge.refusesAloud() ? told(state, aloud) : Step.none(state);
  }

  private static Step<ResponderState, ResponderAction> told(ResponderState state, Refuse refuse) {
    return new Step<>(state, List.of(new ToOne(refuse.conversation().requester(), refuse)));
  }

  private static Step<ResponderState, ResponderAction> refused(
      ResponderState state, Conversation which, String why) {
    return told(state, new Refuse(which, why, true));
  }

  private Step<ResponderState, ResponderAction> offer(
      ResponderState state, Conversation in, HelpCall call, Offer offer, int sends, Instant now) {
    int bid = state.isIn(in) ? state.offers().size() : 0;
    return new Step<>(
        state.offered(in, call, sends, promise(offer, now), now.plus(settings.repeatEvery())),
        List.of(new ToOne(in.requester(), new Accept(in, bid, offer.eta(), offer.battery()))));
  }

  /** When it turns back, which is before the requester gives it up. */
  private Instant promise(Offer offer, Instant now) {
    return now.plus(offer.eta()).plus(settings.replaceAfter()).minus(settings.margin());
  }

  private Step<ResponderState, ResponderAction> repeatOffer(ResponderState state, Instant now) {
    return state.sends() >= settings.acceptSends()
        ? turnBack(state, "it heard no answer")
        : offerAgain(state, state.sends() + 1, now);
  }

  /**
   * @param sends that count since the requester was last heard
   */
  private Step<ResponderState, ResponderAction> offerAgain(
      ResponderState state, int sends, Instant now) {
    return judge
        .offer(state.wanted())
        .map(offer -> offer(state, state.partIn(), state.wanted(), offer, sends, now))
        .orElseGet(() -> turnBack(state, "it cannot come any more"));
  }

  private Step<ResponderState, ResponderAction> chosen(
      ResponderState state, ResponderId id, Instant now) {
    Conversation in = id.conversation();
    if (!state.isIn(in)) {
      return state.ledger(in).completed() >= in.number()
          ? Step.none(state)
          : refused(state.close(in), in, "it is out of this");
    }
    if (id.bid() < 0 || id.bid() >= state.offers().size()) {
      return Step.none(state); // no offer that it has made
    }
    Instant promise = state.offers().get(id.bid());
    return switch (state.phase()) {
      case OFFERED -> setOut(state, promise, now);
      case TRAVELLING ->
          promise.isAfter(state.until())
              ? new Step<>(state.prolonged(promise), List.of(new Extend(promise)))
              : Step.none(state);
      default -> Step.none(state);
    };
  }

  private Step<ResponderState, ResponderAction> setOut(
      ResponderState state, Instant promise, Instant now) {
    Optional<Duration> eta = judge.offer(state.wanted()).map(Offer::eta);
    if (eta.isEmpty() || !now.plus(eta.get()).isBefore(promise)) {
      return turnBack(state, "it could not be there in time any more");
    }
    return new Step<>(
        state.travelling(promise), List.of(new Atone(), new Go(state.wanted(), promise)));
  }

  private Step<ResponderState, ResponderAction> passedOver(
      ResponderState state, RecruitmentMessage message) {
    Conversation which = message.conversation();
    if (state.isIn(which)) {
      Step<ResponderState, ResponderAction> freed = free(state, "it is not wanted any more");
      return state.phase().isCommitted() ? freed : relieved(freed.state());
    }
    boolean isNews = which.number() > state.ledger(which).closed();
    ResponderState closed = state.close(which);
    return isNews && state.phase() == ResponderPhase.FREE ? relieved(closed) : Step.none(closed);
  }

  private Step<ResponderState, ResponderAction> released(ResponderState state, Release release) {
    Conversation which = release.conversation();
    Step<ResponderState, ResponderAction> step = passedOver(state, release);
    if (!release.wantsAnswer()) {
      return step;
    }
    List<ResponderAction> actions = new ArrayList<>(step.actions());
    actions.add(new ToOne(which.requester(), new Refuse(which, "it was let go", true)));
    return new Step<>(step.state(), actions);
  }

  private static Step<ResponderState, ResponderAction> relieved(ResponderState state) {
    return new Step<>(state, List.of(new Relieve()));
  }

  private static Step<ResponderState, ResponderAction> agreed(
      ResponderState state, Conversation which) {
    ToOne ackAck = new ToOne(which.requester(), new AckAck(which));
    if (state.isIn(which) && state.phase() == ResponderPhase.ARRIVED) {
      ResponderState known =
          state.remember(which.requester(), state.ledger(which).complete(which.number()));
      return new Step<>(known.leased(), List.of(ackAck, new Observe(state.wanted())));
    }
    boolean isKnown = state.ledger(which).completed() == which.number();
    return isKnown
        ? new Step<>(state, List.of(ackAck))
        : refused(state.close(which), which, "it has left");
  }

  /** It is there. Nothing where it does not travel any more. */
  public Step<ResponderState, ResponderAction> arrived(
      ResponderState before, UUID lease, Duration stay, Instant now) {
    List<ResponderAction> actions = new ArrayList<>();
    ResponderState state = taken(tick(before, now), actions);
    if (state.phase() != ResponderPhase.TRAVELLING) {
      actions.add(new EndLease(lease));
      return new Step<>(state, actions);
    }
    Conversation in = state.partIn();
    actions.add(new ToOne(in.requester(), new Arrival(in, lease, stay)));
    return new Step<>(
        state.arrived(lease, now.plus(stay), now.plus(settings.repeatEvery())), actions);
  }

  /** It cannot go on with it. Nothing where it has no part in anything. */
  public Step<ResponderState, ResponderAction> unable(ResponderState state, String why) {
    return state.phase() == ResponderPhase.FREE ? Step.none(state) : turnBack(state, why);
  }

  /** The lease has ended, or somebody has ended it. Nothing where it is another. */
  public Step<ResponderState, ResponderAction> leaseOver(
      ResponderState state, UUID lease, Instant now) {
    if (!lease.equals(state.lease())) {
      return Step.none(state);
    }
    boolean isAsAgreed =
        state.phase() == ResponderPhase.LEASED && state.stay(now).compareTo(settings.margin()) <= 0;
    return isAsAgreed
        ? free(state, "its lease is over")
        : turnBack(state, "its lease was ended early");
  }

  /** Time has passed. */
  public Step<ResponderState, ResponderAction> tick(ResponderState state, Instant now) {
    if (now.isBefore(state.wake())) {
      return Step.none(state);
    }
    return switch (state.phase()) {
      case FREE -> Step.none(state);
      case OFFERED -> repeatOffer(state, now);
      case TRAVELLING -> turnBack(state, "it could not be there in time");
      case ARRIVED -> arriveAgain(state, now);
      case LEASED -> free(state, "its lease is over");
    };
  }

  private Step<ResponderState, ResponderAction> arriveAgain(ResponderState state, Instant now) {
    UUID lease = state.lease();
    boolean isLate = !now.isBefore(state.until()) || state.sends() >= settings.arrivalSends();
    if (isLate || lease == null) {
      return turnBack(state, "it heard no answer");
    }
    Conversation in = state.partIn();
    return new Step<>(
        state.saidAgain(now.plus(settings.repeatEvery())),
        List.of(new ToOne(in.requester(), new Arrival(in, lease, state.stay(now)))));
  }

  /** Is free, and says so to whom it had offered to help. */
  private static Step<ResponderState, ResponderAction> turnBack(ResponderState state, String why) {
    Conversation left = state.partIn();
    List<ResponderAction> actions = new ArrayList<>(free(state, why).actions());
    actions.add(0, new ToOne(left.requester(), new Refuse(left, why, true)));
    return new Step<>(state.freed(), actions);
  }

  private static Step<ResponderState, ResponderAction> free(ResponderState state, String why) {
    List<ResponderAction> actions = new ArrayList<>();
    UUID lease = state.lease();
    if (lease != null) {
      actions.add(new EndLease(lease));
    }
    if (state.phase().isCommitted()) {
      actions.add(new Resume(why));
    }
    return new Step<>(state.freed(), actions);
  }
}
