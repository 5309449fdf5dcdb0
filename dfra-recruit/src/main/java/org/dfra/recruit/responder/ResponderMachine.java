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
import org.dfra.recruit.TransitionResult;
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
import org.dfra.recruit.responder.ResponderAction.EndLease;
import org.dfra.recruit.responder.ResponderAction.ExtendLease;
import org.dfra.recruit.responder.ResponderAction.Observe;
import org.dfra.recruit.responder.ResponderAction.ResetOnHelping;
import org.dfra.recruit.responder.ResponderAction.ResetOnRelease;
import org.dfra.recruit.responder.ResponderAction.ResumeOwnWork;
import org.dfra.recruit.responder.ResponderAction.SendToRobot;
import org.dfra.recruit.responder.ResponderAction.TravelTo;
import org.dfra.recruit.responder.ResponderMachine.ResponderPolicy.Offer;

/**
 * State machine of a responder, with the transitions of {@link ResponderPhase}. Pure except for the
 * queries of its {@link ResponderPolicy}: each method returns the next state and the actions,
 * without side effects. Even if messages are lost, late, duplicated or reordered:
 *
 * <ul>
 *   <li>It becomes free again: every state except {@code FREE} has a timeout.
 *   <li>After leaving a conversation it takes no part in it any more; it refuses a choice there,
 *       and answers a repeated AGREE with a repeated ACK_ACK.
 *   <li>A message of a newer conversation of the same requester frees it from the older one.
 * </ul>
 */
public final class ResponderMachine {

  private final String robot;
  private final RecruitmentSettings settings;
  private final ResponderPolicy judge;

  /**
   * @param robot its own name
   */
  public ResponderMachine(String robot, RecruitmentSettings settings, ResponderPolicy judge) {
    this.robot = robot;
    this.settings = settings;
    this.judge = judge;
  }

  /** Handles a message of a requester. Messages for requesters are ignored. */
  public TransitionResult<ResponderState, ResponderAction> receive(
      ResponderState before, RecruitmentMessage message, Instant now) {
    List<ResponderAction> actions = new ArrayList<>();
    ResponderState state = taken(tick(before, now), actions);
    if (isToResponders(message)) {
      Conversation mine = state.conversation();
      if (mine != null && message.conversation().supersedes(mine)) {
        state = taken(free(state, "the call continues without it"), actions);
      }
      state = taken(receiveNow(state, message, now), actions);
    }
    return new TransitionResult<>(state, actions);
  }

  private static boolean isToResponders(RecruitmentMessage message) {
    return message instanceof Help
        || message instanceof ResponderId
        || message instanceof Agree
        || message instanceof Release;
  }

  private static ResponderState taken(
      TransitionResult<ResponderState, ResponderAction> step, List<ResponderAction> actions) {
    actions.addAll(step.actions());
    return step.state();
  }

  private TransitionResult<ResponderState, ResponderAction> receiveNow(
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

  private TransitionResult<ResponderState, ResponderAction> help(
      ResponderState before, Help help, Instant now) {
    Conversation asked = help.conversation();
    ConversationRecord record = before.record(asked);
    if (record.hasReceived(asked.number(), help.round())) {
      return TransitionResult.none(before);
    }
    ResponderState state =
        before.remember(asked.requester(), record.recordCall(asked.number(), help.round()));
    if (state.isIn(asked)) { // the offer was lost, or is still in transit
      return state.phase() == ResponderPhase.OFFERED
          ? offerAgain(state, 1, now)
          : TransitionResult.none(state);
    }
    boolean isOver = asked.number() <= record.closed();
    if (isOver || state.phase() != ResponderPhase.FREE) {
      String why = isOver ? "it has left this conversation" : "it helps another robot";
      return declined(state, new Refuse(asked, why, isOver));
    }
    Optional<Offer> offer = judge.offer(help.call());
    return offer.isPresent() && judge.shouldOffer(help, offer.get())
        ? offer(state, asked, help.call(), offer.get(), 1, now)
        : declined(state, new Refuse(asked, "it is not able or not willing to help", false));
  }

  private TransitionResult<ResponderState, ResponderAction> declined(
      ResponderState state, Refuse aloud) {
    return judge.sendsRefusal() ? send(state, aloud) : TransitionResult.none(state);
  }

  private static TransitionResult<ResponderState, ResponderAction> send(
      ResponderState state, Refuse refuse) {
    return new TransitionResult<>(
        state, List.of(new SendToRobot(refuse.conversation().requester(), refuse)));
  }

  private static TransitionResult<ResponderState, ResponderAction> refused(
      ResponderState state, Conversation which, String why) {
    return send(state, new Refuse(which, why, true));
  }

  private TransitionResult<ResponderState, ResponderAction> offer(
      ResponderState state, Conversation in, HelpCall call, Offer offer, int sends, Instant now) {
    int bid = state.isIn(in) ? state.offers().size() : 0;
    return new TransitionResult<>(
        state.offered(in, call, sends, promise(offer, now), now.plus(settings.repeatEvery())),
        List.of(
            new SendToRobot(in.requester(), new Accept(in, bid, offer.eta(), offer.battery()))));
  }

  /** Time of its withdrawal, which is before the requester gives it up. */
  private Instant promise(Offer offer, Instant now) {
    return now.plus(offer.eta()).plus(settings.replaceAfter()).minus(settings.margin());
  }

  private TransitionResult<ResponderState, ResponderAction> repeatOffer(
      ResponderState state, Instant now) {
    return state.sends() >= settings.acceptSends()
        ? turnBack(state, "it received no answer")
        : offerAgain(state, state.sends() + 1, now);
  }

  /**
   * @param sends transmissions since the last message of the requester
   */
  private TransitionResult<ResponderState, ResponderAction> offerAgain(
      ResponderState state, int sends, Instant now) {
    return judge
        .offer(state.requireCall())
        .map(
            offer ->
                offer(state, state.requireConversation(), state.requireCall(), offer, sends, now))
        .orElseGet(() -> turnBack(state, "it cannot come any more"));
  }

  private TransitionResult<ResponderState, ResponderAction> chosen(
      ResponderState state, ResponderId id, Instant now) {
    Conversation in = id.conversation();
    if (!state.isIn(in)) {
      return state.record(in).completed() >= in.number()
          ? TransitionResult.none(state)
          : refused(state.close(in), in, "it has left this conversation");
    }
    if (id.bid() < 0 || id.bid() >= state.offers().size()) {
      return TransitionResult.none(state); // not an offer of this robot
    }
    Instant promise = state.offers().get(id.bid());
    return switch (state.phase()) {
      case OFFERED -> setOut(state, promise, now);
      case TRAVELLING ->
          promise.isAfter(state.until())
              ? new TransitionResult<>(state.extended(promise), List.of(new ExtendLease(promise)))
              : TransitionResult.none(state);
      default -> TransitionResult.none(state);
    };
  }

  private TransitionResult<ResponderState, ResponderAction> setOut(
      ResponderState state, Instant promise, Instant now) {
    Optional<Duration> eta = judge.offer(state.requireCall()).map(Offer::eta);
    if (eta.isEmpty() || !now.plus(eta.get()).isBefore(promise)) {
      return turnBack(state, "it could no longer arrive in time");
    }
    return new TransitionResult<>(
        state.travelling(promise),
        List.of(new ResetOnHelping(), new TravelTo(state.requireCall(), promise)));
  }

  private TransitionResult<ResponderState, ResponderAction> passedOver(
      ResponderState state, RecruitmentMessage message) {
    Conversation which = message.conversation();
    if (state.isIn(which)) {
      TransitionResult<ResponderState, ResponderAction> freed =
          free(state, "it is no longer needed");
      return state.phase().isCommitted() ? freed : relieved(freed.state());
    }
    boolean isNews = which.number() > state.record(which).closed();
    ResponderState closed = state.close(which);
    return isNews && state.phase() == ResponderPhase.FREE
        ? relieved(closed)
        : TransitionResult.none(closed);
  }

  private TransitionResult<ResponderState, ResponderAction> released(
      ResponderState state, Release release) {
    Conversation which = release.conversation();
    TransitionResult<ResponderState, ResponderAction> step = passedOver(state, release);
    if (!release.wantsAnswer()) {
      return step;
    }
    List<ResponderAction> actions = new ArrayList<>(step.actions());
    actions.add(new SendToRobot(which.requester(), new Refuse(which, "it was released", true)));
    return new TransitionResult<>(step.state(), actions);
  }

  private static TransitionResult<ResponderState, ResponderAction> relieved(ResponderState state) {
    return new TransitionResult<>(state, List.of(new ResetOnRelease()));
  }

  private static TransitionResult<ResponderState, ResponderAction> agreed(
      ResponderState state, Conversation which) {
    SendToRobot ackAck = new SendToRobot(which.requester(), new AckAck(which));
    if (state.isIn(which) && state.phase() == ResponderPhase.ARRIVED) {
      ResponderState known =
          state.remember(which.requester(), state.record(which).complete(which.number()));
      return new TransitionResult<>(
          known.leased(), List.of(ackAck, new Observe(state.requireCall())));
    }
    boolean isKnown = state.record(which).completed() == which.number();
    return isKnown
        ? new TransitionResult<>(state, List.of(ackAck))
        : refused(state.close(which), which, "it has ended its help");
  }

  /** The robot has arrived. No effect where it does not travel any more. */
  public TransitionResult<ResponderState, ResponderAction> arrived(
      ResponderState before, UUID lease, Duration stay, Instant now) {
    List<ResponderAction> actions = new ArrayList<>();
    ResponderState state = taken(tick(before, now), actions);
    if (state.phase() != ResponderPhase.TRAVELLING) {
      actions.add(new EndLease(lease));
      return new TransitionResult<>(state, actions);
    }
    Conversation in = state.requireConversation();
    actions.add(new SendToRobot(in.requester(), new Arrival(in, lease, stay)));
    return new TransitionResult<>(
        state.arrived(lease, now.plus(stay), now.plus(settings.repeatEvery())), actions);
  }

  /** The robot cannot continue. No effect where it is free. */
  public TransitionResult<ResponderState, ResponderAction> abort(ResponderState state, String why) {
    return state.phase() == ResponderPhase.FREE
        ? TransitionResult.none(state)
        : turnBack(state, why);
  }

  /** The lease has expired or was cancelled. No effect for another lease. */
  public TransitionResult<ResponderState, ResponderAction> leaseEnded(
      ResponderState state, UUID lease, Instant now) {
    if (!lease.equals(state.lease())) {
      return TransitionResult.none(state);
    }
    boolean isAsAgreed =
        state.phase() == ResponderPhase.LEASED
            && state.remainingStay(now).compareTo(settings.margin()) <= 0;
    return isAsAgreed
        ? free(state, "its lease has ended")
        : turnBack(state, "its lease was ended early");
  }

  /** Advances the time. */
  public TransitionResult<ResponderState, ResponderAction> tick(ResponderState state, Instant now) {
    if (now.isBefore(state.nextWake())) {
      return TransitionResult.none(state);
    }
    return switch (state.phase()) {
      case FREE -> TransitionResult.none(state);
      case OFFERED -> repeatOffer(state, now);
      case TRAVELLING -> turnBack(state, "it could not arrive in time");
      case ARRIVED -> arriveAgain(state, now);
      case LEASED -> free(state, "its lease has ended");
    };
  }

  private TransitionResult<ResponderState, ResponderAction> arriveAgain(
      ResponderState state, Instant now) {
    UUID lease = state.lease();
    boolean isLate = !now.isBefore(state.until()) || state.sends() >= settings.arrivalSends();
    if (isLate || lease == null) {
      return turnBack(state, "it received no answer");
    }
    Conversation in = state.requireConversation();
    return new TransitionResult<>(
        state.repeated(now.plus(settings.repeatEvery())),
        List.of(new SendToRobot(in.requester(), new Arrival(in, lease, state.remainingStay(now)))));
  }

  /** Becomes free, and notifies the requester that it had offered help. */
  private static TransitionResult<ResponderState, ResponderAction> turnBack(
      ResponderState state, String why) {
    Conversation left = state.requireConversation();
    List<ResponderAction> actions = new ArrayList<>(free(state, why).actions());
    actions.add(0, new SendToRobot(left.requester(), new Refuse(left, why, true)));
    return new TransitionResult<>(state.freed(), actions);
  }

  private static TransitionResult<ResponderState, ResponderAction> free(
      ResponderState state, String why) {
    List<ResponderAction> actions = new ArrayList<>();
    UUID lease = state.lease();
    if (lease != null) {
      actions.add(new EndLease(lease));
    }
    if (state.phase().isCommitted()) {
      actions.add(new ResumeOwnWork(why));
    }
    return new TransitionResult<>(state.freed(), actions);
  }

  /** A responder's queries of its robot and its strategy. */
  public interface ResponderPolicy {

    /**
     * A possible offer.
     *
     * @param eta time to reach the place
     * @param battery charge left, 0 to 1
     */
    record Offer(Duration eta, double battery) {}

    /**
     * Its possible offer now; empty where it cannot observe the percept, cannot come, or is not
     * free.
     */
    Optional<Offer> offer(HelpCall call);

    /** Whether it offers. Called once per call of a conversation, and only while it is free. */
    boolean shouldOffer(Help help, Offer offer);

    /** Whether it sends a refusal when it does not offer. */
    boolean sendsRefusal();
  }
}
