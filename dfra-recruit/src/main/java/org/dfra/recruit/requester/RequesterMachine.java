package org.dfra.recruit.requester;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dfra.agent.HelpCall;
import org.dfra.agent.RequesterPhase;
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
import org.dfra.recruit.requester.RequesterAction.AcceptLease;
import org.dfra.recruit.requester.RequesterAction.Complete;
import org.dfra.recruit.requester.RequesterAction.EndCall;
import org.dfra.recruit.requester.RequesterAction.ReplaceHelper;
import org.dfra.recruit.requester.RequesterAction.SendToRobot;
import org.dfra.recruit.requester.RequesterAction.SendToTeam;

/**
 * State machine of a requester, with the transitions of {@link RequesterPhase}. Pure: each method
 * returns the next state and the actions, without side effects. Even if messages are lost, late,
 * duplicated or reordered:
 *
 * <ul>
 *   <li>There is never a second helper. No other robot is called before the chosen robot has
 *       confirmed that it is free, or its task lease has ended by its own clock. That lease ends
 *       {@link RecruitmentSettings#margin} before the requester gives the robot up, see {@link
 *       ResponderId}; in the second half of the margin the requester sends a RELEASE, so that the
 *       robot is replaced as soon as it acknowledges that.
 *   <li>A call after the release of a helper waits for the same condition.
 *   <li>An offer after the choice is answered by a RESPONDER_ID to its sender alone; one of an
 *       earlier conversation, and an unexpected ARRIVAL, by a RELEASE.
 *   <li>AGREE is repeated until ACK_ACK is received or the lease ends; so is the RELEASE of a
 *       helper before its lease's end, until it is acknowledged.
 * </ul>
 */
public final class RequesterMachine {

  private static final String LATE = "did not arrive in time";

  private final RecruitmentSettings settings;
  private final BidSelector chooser;
  private final ReleaseRepeater parting;

  public RequesterMachine(RecruitmentSettings settings, BidSelector chooser) {
    this.settings = settings;
    this.chooser = chooser;
    this.parting = new ReleaseRepeater(settings.releaseEvery());
  }

  /**
   * Starts a call. A helper of the previous call is released.
   *
   * @throws IllegalStateException if a call is active
   */
  public TransitionResult<RequesterState, RequesterAction> call(
      RequesterState state, HelpCall call, Instant now) {
    if (state.phase().isUnderWay()) {
      throw new IllegalStateException(
          state.conversation() + " cannot begin another call while " + state.phase());
    }
    List<RequesterAction> actions = new ArrayList<>();
    RequesterState before = state;
    if (state.phase() == RequesterPhase.BEING_HELPED) {
      before = taken(parting.release(state, "another call", now), actions);
      actions.add(
          new EndCall(true, state.requireWinner().robot() + " was released for another call"));
    }
    return open(before, call, now.plus(call.searchTimeout()), now, actions);
  }

  private TransitionResult<RequesterState, RequesterAction> open(
      RequesterState state,
      HelpCall call,
      Instant patience,
      Instant now,
      List<RequesterAction> actions) {
    Conversation next = state.conversation().next();
    PendingRelease pendingRelease = state.farewell();
    if (pendingRelease != null) {
      Instant free = pendingRelease.until().isBefore(patience) ? pendingRelease.until() : patience;
      return new TransitionResult<>(state.open(next, call, patience, free).waiting(free), actions);
    }
    actions.add(new SendToTeam(call.percept(), new Help(next, call, 1)));
    return new TransitionResult<>(state.open(next, call, patience, again(now, patience)), actions);
  }

  /** Time of the next call, or of the end of its patience. */
  private Instant again(Instant now, Instant patience) {
    Instant again = now.plus(settings.helpEvery());
    return again.isBefore(patience) ? again : patience;
  }

  /** Cancels the call. */
  public TransitionResult<RequesterState, RequesterAction> release(
      RequesterState state, Instant now) {
    return switch (state.phase()) {
      case IDLE -> TransitionResult.none(state);
      case CALLING, COLLECTING -> giveUp(state, "it is no longer needed");
      case AWARDED, ON_SITE ->
          ended(parting.release(state, "no longer needed", now), false, "it is no longer needed");
      case BEING_HELPED ->
          ended(
              parting.release(state, "the help is complete", now),
              true,
              state.requireWinner().robot() + " was released");
    };
  }

  private static TransitionResult<RequesterState, RequesterAction> ended(
      TransitionResult<RequesterState, RequesterAction> step, boolean success, String why) {
    List<RequesterAction> actions = new ArrayList<>(step.actions());
    actions.add(new EndCall(success, why));
    return new TransitionResult<>(step.state().ended(), actions);
  }

  private static RequesterState taken(
      TransitionResult<RequesterState, RequesterAction> step, List<RequesterAction> actions) {
    actions.addAll(step.actions());
    return step.state();
  }

  /** Time has passed. */
  public TransitionResult<RequesterState, RequesterAction> tick(
      RequesterState before, Instant now) {
    List<RequesterAction> actions = new ArrayList<>();
    RequesterState state = taken(parting.tick(before, now), actions);
    return new TransitionResult<>(taken(goOn(state, now), actions), actions);
  }

  private TransitionResult<RequesterState, RequesterAction> goOn(
      RequesterState state, Instant now) {
    boolean isFreeToAsk = state.isWaiting() && state.farewell() == null;
    if (now.isBefore(state.due()) && !isFreeToAsk) {
      return TransitionResult.none(state);
    }
    return switch (state.phase()) {
      case IDLE -> TransitionResult.none(state);
      case CALLING -> callAgain(state, now);
      case COLLECTING -> award(state, now);
      case AWARDED -> giveUpWinner(state, now);
      case ON_SITE -> agreeAgain(state, now);
      case BEING_HELPED ->
          new TransitionResult<>(
              state.ended(),
              List.of(
                  new EndCall(
                      true, "the lease of " + state.requireWinner().robot() + " has ended")));
    };
  }

  private TransitionResult<RequesterState, RequesterAction> callAgain(
      RequesterState state, Instant now) {
    if (!now.isBefore(state.patience())) {
      return giveUp(state, "no robot offered to arrive in time");
    }
    HelpCall call = state.requireCall();
    if (state.round() >= settings.roundsPerConversation()) {
      return open(state, call, state.patience(), now, new ArrayList<>());
    }
    int round = state.round() + 1;
    return new TransitionResult<>(
        state.calling(round, again(now, state.patience())),
        List.of(new SendToTeam(call.percept(), new Help(state.conversation(), call, round))));
  }

  private static TransitionResult<RequesterState, RequesterAction> giveUp(
      RequesterState state, String why) {
    return new TransitionResult<>(
        state.ended(),
        List.of(
            new SendToTeam(
                state.requireCall().percept(), new Release(state.conversation(), why, false)),
            new EndCall(false, why)));
  }

  private TransitionResult<RequesterState, RequesterAction> award(
      RequesterState state, Instant now) {
    Bid winner = chooser.choose(state.bids());
    ResponderId news = new ResponderId(state.conversation(), winner.robot(), winner.number());
    List<RequesterAction> actions = new ArrayList<>();
    if (chooser.notifiesIndividually()) {
      actions.add(new SendToRobot(winner.robot(), news));
      for (Bid bid : state.bids()) {
        if (!bid.robot().equals(winner.robot())) {
          actions.add(release(state, bid.robot(), winner.robot() + " was chosen"));
        }
      }
    } else {
      actions.add(new SendToTeam(state.requireCall().percept(), news));
    }
    return new TransitionResult<>(awarded(state, winner, patienceWith(winner.eta(), now)), actions);
  }

  private RequesterState awarded(RequesterState state, Bid winner, Instant until) {
    return state.awarded(winner, until.minus(settings.margin().dividedBy(2)), until);
  }

  /**
   * The helper's task lease has ended by its own clock. It is requested to confirm that for a
   * limited time.
   */
  private TransitionResult<RequesterState, RequesterAction> giveUpWinner(
      RequesterState state, Instant now) {
    if (!now.isBefore(state.until())) {
      return replace(state, LATE, now);
    }
    Bid winner = state.requireWinner();
    return new TransitionResult<>(
        state.awarded(winner, now.plus(settings.releaseEvery()), state.until()),
        List.of(new SendToRobot(winner.robot(), new Release(state.conversation(), LATE, true))));
  }

  private Instant patienceWith(Duration eta, Instant now) {
    return now.plus(eta).plus(settings.replaceAfter());
  }

  private TransitionResult<RequesterState, RequesterAction> agreeAgain(
      RequesterState state, Instant now) {
    if (!now.isBefore(state.until())) {
      return replace(state, "did not confirm that it stays", now);
    }
    return new TransitionResult<>(
        state.onSite(now.plus(settings.agreeEvery()), state.until()),
        List.of(new SendToRobot(state.requireWinner().robot(), new Agree(state.conversation()))));
  }

  /** The chosen robot has withdrawn, or its timeout has expired. */
  private TransitionResult<RequesterState, RequesterAction> replace(
      RequesterState state, String why, Instant now) {
    String robot = state.requireWinner().robot();
    List<RequesterAction> actions = new ArrayList<>(List.of(new ReplaceHelper(robot, why)));
    if (!now.isBefore(state.patience())) {
      actions.add(new EndCall(false, robot + " " + why + ", and it is too late to call another"));
      return new TransitionResult<>(state.ended(), actions);
    }
    return open(state, state.requireCall(), state.patience(), now, actions);
  }

  /** Handles a message of a responder. Messages for responders are ignored. */
  public TransitionResult<RequesterState, RequesterAction> receive(
      RequesterState before, String from, RecruitmentMessage message, Instant now) {
    List<RequesterAction> actions = new ArrayList<>();
    RequesterState state =
        taken(tick(ReleaseRepeater.receive(before, from, message), now), actions);
    TransitionResult<RequesterState, RequesterAction> step =
        message.conversation().equals(state.conversation())
            ? receiveNow(state, from, message, now)
            : receiveLate(state, from, message);
    return new TransitionResult<>(taken(step, actions), actions);
  }

  private static TransitionResult<RequesterState, RequesterAction> receiveLate(
      RequesterState state, String from, RecruitmentMessage message) {
    boolean wantsAnswer = message instanceof Accept || message instanceof Arrival;
    return wantsAnswer && state.conversation().supersedes(message.conversation())
        ? released(state, from, message.conversation())
        : TransitionResult.none(state);
  }

  private TransitionResult<RequesterState, RequesterAction> receiveNow(
      RequesterState state, String from, RecruitmentMessage message, Instant now) {
    if (message instanceof Accept accept) {
      return accept(state, from, accept, now);
    }
    if (message instanceof Refuse refuse) {
      return refuse(state, from, refuse, now);
    }
    if (message instanceof Arrival arrival) {
      return arrival(state, from, arrival, now);
    }
    boolean isConfirmed =
        message instanceof AckAck
            && state.phase() == RequesterPhase.ON_SITE
            && state.isWinner(from);
    return isConfirmed
        ? new TransitionResult<>(state.done(), List.of(new Complete(from)))
        : TransitionResult.none(state);
  }

  private TransitionResult<RequesterState, RequesterAction> accept(
      RequesterState state, String from, Accept accept, Instant now) {
    Bid bid = new Bid(from, accept.bid(), accept.eta(), accept.battery());
    return switch (state.phase()) {
      case CALLING ->
          new TransitionResult<>(
              state.collecting(
                  List.of(bid), now.plus(settings.offerWindowOr(chooser.offerWindow()))),
              List.of());
      case COLLECTING ->
          new TransitionResult<>(
              state.collecting(BidList.with(state.bids(), bid), state.due()), List.of());
      case AWARDED -> state.isWinner(from) ? remind(state, bid, now) : inform(state, from);
      case ON_SITE, BEING_HELPED ->
          state.isWinner(from) ? TransitionResult.none(state) : inform(state, from);
      case IDLE -> released(state, from, state.conversation());
    };
  }

  /** The robot does not know yet that it was chosen. */
  private TransitionResult<RequesterState, RequesterAction> remind(
      RequesterState state, Bid bid, Instant now) {
    Bid chosen = state.requireWinner();
    Instant patience = patienceWith(bid.eta(), now);
    boolean isNews = bid.number() > chosen.number() && patience.isAfter(state.until());
    RequesterState next = isNews ? awarded(state, bid, patience) : state;
    return inform(next, bid.robot());
  }

  private static TransitionResult<RequesterState, RequesterAction> inform(
      RequesterState state, String robot) {
    Bid winner = state.requireWinner();
    return new TransitionResult<>(
        state,
        List.of(
            new SendToRobot(
                robot, new ResponderId(state.conversation(), winner.robot(), winner.number()))));
  }

  private TransitionResult<RequesterState, RequesterAction> refuse(
      RequesterState state, String from, Refuse refuse, Instant now) {
    if (!refuse.isFinal()) {
      return TransitionResult.none(state); // it does not refer to a newer offer
    }
    return switch (state.phase()) {
      case IDLE, CALLING -> TransitionResult.none(state);
      case COLLECTING -> withdraw(state, from, now);
      case AWARDED, ON_SITE ->
          state.isWinner(from)
              ? replace(state, "turned back: " + refuse.why(), now)
              : TransitionResult.none(state);
      case BEING_HELPED ->
          state.isWinner(from)
              ? new TransitionResult<>(
                  state.ended(),
                  List.of(new EndCall(true, from + " has ended its help: " + refuse.why())))
              : TransitionResult.none(state);
    };
  }

  private TransitionResult<RequesterState, RequesterAction> withdraw(
      RequesterState state, String from, Instant now) {
    List<Bid> left = BidList.without(state.bids(), from);
    return new TransitionResult<>(
        left.isEmpty()
            ? state.calling(state.round(), again(now, state.patience()))
            : state.collecting(left, state.due()),
        List.of());
  }

  private TransitionResult<RequesterState, RequesterAction> arrival(
      RequesterState state, String from, Arrival arrival, Instant now) {
    boolean isAwaited = state.isWinner(from);
    if (isAwaited && state.phase() == RequesterPhase.AWARDED) {
      Instant end = now.plus(arrival.stay());
      return new TransitionResult<>(
          state.onSite(now.plus(settings.agreeEvery()), end),
          List.of(
              new AcceptLease(from, arrival.lease(), arrival.stay()),
              new SendToRobot(from, new Agree(state.conversation()))));
    }
    if (isAwaited && state.phase() == RequesterPhase.ON_SITE) {
      return new TransitionResult<>(
          state, List.of(new SendToRobot(from, new Agree(state.conversation()))));
    }
    return isAwaited && state.phase() == RequesterPhase.BEING_HELPED
        ? TransitionResult.none(state)
        : released(state, from, arrival.conversation());
  }

  private static TransitionResult<RequesterState, RequesterAction> released(
      RequesterState state, String robot, Conversation which) {
    return new TransitionResult<>(
        state, List.of(new SendToRobot(robot, new Release(which, "that call has ended", false))));
  }

  private static SendToRobot release(RequesterState state, String robot, String why) {
    return new SendToRobot(robot, new Release(state.conversation(), why, false));
  }
}
