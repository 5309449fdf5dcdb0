package org.dfra.recruit.requester;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dfra.agent.HelpCall;
import org.dfra.agent.RequesterPhase;
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
import org.dfra.recruit.requester.RequesterAction.Complete;
import org.dfra.recruit.requester.RequesterAction.End;
import org.dfra.recruit.requester.RequesterAction.Hold;
import org.dfra.recruit.requester.RequesterAction.Replace;
import org.dfra.recruit.requester.RequesterAction.ToOne;
import org.dfra.recruit.requester.RequesterAction.ToTeam;

/**
 * Moves who needs help along the arrows of {@link RequesterPhase}. Pure: each method gives the next
 * state and what is to be done, and changes nothing. Whatever is lost, comes late, twice or in
 * another order:
 *
 * <ul>
 *   <li>There is never a second helper. Nobody else is asked before the chosen robot has confirmed
 *       that it is free, or its lease of the task has ended by its own clock. That lease ends
 *       {@link RecruitmentSettings#margin} before the requester gives the robot up, which {@link
 *       ResponderId} explains; in the second half of the margin the robot is sent a RELEASE, so
 *       that it is replaced as soon as it confirms that.
 *   <li>A call for which a helper was let go waits for the same before it asks anybody.
 *   <li>An offer after the choice is answered by a RESPONDER_ID to its sender alone; one of an
 *       earlier conversation, and an ARRIVAL that nobody awaits, by a RELEASE.
 *   <li>AGREE is repeated until ACK_ACK comes or the lease ends; so is the RELEASE of a helper that
 *       is let go before its time, until it says that it knows.
 * </ul>
 */
public final class RequesterMachine {

  private static final String LATE = "did not come in time";

  private final RecruitmentSettings settings;
  private final Chooser chooser;
  private final Parting parting;

  public RequesterMachine(RecruitmentSettings settings, Chooser chooser) {
    this.settings = settings;
    this.chooser = chooser;
    this.parting = new Parting(settings.releaseEvery());
  }

  /**
   * Somebody wants help. A helper of the call before is let go.
   *
   * @throws IllegalStateException if a call is under way
   */
  public Step<RequesterState, RequesterAction> call(
      RequesterState state, HelpCall call, Instant now) {
    if (state.phase().isUnderWay()) {
      throw new IllegalStateException(
          state.conversation() + " cannot begin another call while " + state.phase());
    }
    List<RequesterAction> actions = new ArrayList<>();
    RequesterState before = state;
    if (state.phase() == RequesterPhase.DONE) {
      before = taken(parting.letGo(state, "another call", now), actions);
      actions.add(new End(true, state.chosen().robot() + " was let go for another call"));
    }
    return open(before, call, now.plus(call.patience()), now, actions);
  }

  private Step<RequesterState, RequesterAction> open(
      RequesterState state,
      HelpCall call,
      Instant patience,
      Instant now,
      List<RequesterAction> actions) {
    Conversation next = state.conversation().next();
    Farewell farewell = state.farewell();
    if (farewell != null) {
      Instant free = farewell.until().isBefore(patience) ? farewell.until() : patience;
      return new Step<>(state.open(next, call, patience, free).waiting(free), actions);
    }
    actions.add(new ToTeam(call.percept(), new Help(next, call, 1)));
    return new Step<>(state.open(next, call, patience, again(now, patience)), actions);
  }

  /** When it calls again, or has lost its patience. */
  private Instant again(Instant now, Instant patience) {
    Instant again = now.plus(settings.helpEvery());
    return again.isBefore(patience) ? again : patience;
  }

  /** Nobody wants the help any more. */
  public Step<RequesterState, RequesterAction> release(RequesterState state, Instant now) {
    return switch (state.phase()) {
      case IDLE -> Step.none(state);
      case CALLING, COLLECTING -> giveUp(state, "it is not wanted any more");
      case AWARDED, ON_SITE ->
          ended(
              parting.letGo(state, "not wanted any more", now), false, "it is not wanted any more");
      case DONE ->
          ended(
              parting.letGo(state, "that was all", now),
              true,
              state.chosen().robot() + " was let go");
    };
  }

  private static Step<RequesterState, RequesterAction> ended(
      Step<RequesterState, RequesterAction> step, boolean success, String why) {
    List<RequesterAction> actions = new ArrayList<>(step.actions());
    actions.add(new End(success, why));
    return new Step<>(step.state().ended(), actions);
  }

  private static RequesterState taken(
      Step<RequesterState, RequesterAction> step, List<RequesterAction> actions) {
    actions.addAll(step.actions());
    return step.state();
  }

  /** Time has passed. */
  public Step<RequesterState, RequesterAction> tick(RequesterState before, Instant now) {
    List<RequesterAction> actions = new ArrayList<>();
    RequesterState state = taken(parting.tick(before, now), actions);
    return new Step<>(taken(goOn(state, now), actions), actions);
  }

  private Step<RequesterState, RequesterAction> goOn(RequesterState state, Instant now) {
    boolean isFreeToAsk = state.isWaiting() && state.farewell() == null;
    if (now.isBefore(state.due()) && !isFreeToAsk) {
      return Step.none(state);
    }
    return switch (state.phase()) {
      case IDLE -> Step.none(state);
      case CALLING -> callAgain(state, now);
      case COLLECTING -> award(state, now);
      case AWARDED -> giveUpWinner(state, now);
      case ON_SITE -> agreeAgain(state, now);
      case DONE ->
          new Step<>(
              state.ended(),
              List.of(new End(true, "the lease of " + state.chosen().robot() + " is over")));
    };
  }

  private Step<RequesterState, RequesterAction> callAgain(RequesterState state, Instant now) {
    if (!now.isBefore(state.patience())) {
      return giveUp(state, "nobody offered to come in time");
    }
    HelpCall call = state.wanted();
    if (state.round() >= settings.roundsPerConversation()) {
      return open(state, call, state.patience(), now, new ArrayList<>());
    }
    int round = state.round() + 1;
    return new Step<>(
        state.calling(round, again(now, state.patience())),
        List.of(new ToTeam(call.percept(), new Help(state.conversation(), call, round))));
  }

  private static Step<RequesterState, RequesterAction> giveUp(RequesterState state, String why) {
    return new Step<>(
        state.ended(),
        List.of(
            new ToTeam(state.wanted().percept(), new Release(state.conversation(), why, false)),
            new End(false, why)));
  }

  private Step<RequesterState, RequesterAction> award(RequesterState state, Instant now) {
    Bid winner = chooser.choose(state.bids());
    ResponderId news = new ResponderId(state.conversation(), winner.robot(), winner.number());
    List<RequesterAction> actions = new ArrayList<>();
    if (chooser.answersOneByOne()) {
      actions.add(new ToOne(winner.robot(), news));
      for (Bid bid : state.bids()) {
        if (!bid.robot().equals(winner.robot())) {
          actions.add(release(state, bid.robot(), winner.robot() + " was chosen"));
        }
      }
    } else {
      actions.add(new ToTeam(state.wanted().percept(), news));
    }
    return new Step<>(awarded(state, winner, patienceWith(winner.eta(), now)), actions);
  }

  private RequesterState awarded(RequesterState state, Bid winner, Instant until) {
    return state.awarded(winner, until.minus(settings.margin().dividedBy(2)), until);
  }

  /** Its lease of the task has ended by its own clock. It is asked to confirm that for a while. */
  private Step<RequesterState, RequesterAction> giveUpWinner(RequesterState state, Instant now) {
    if (!now.isBefore(state.until())) {
      return replace(state, LATE, now);
    }
    Bid winner = state.chosen();
    return new Step<>(
        state.awarded(winner, now.plus(settings.releaseEvery()), state.until()),
        List.of(new ToOne(winner.robot(), new Release(state.conversation(), LATE, true))));
  }

  private Instant patienceWith(Duration eta, Instant now) {
    return now.plus(eta).plus(settings.replaceAfter());
  }

  private Step<RequesterState, RequesterAction> agreeAgain(RequesterState state, Instant now) {
    if (!now.isBefore(state.until())) {
      return replace(state, "did not confirm that it stays", now);
    }
    return new Step<>(
        state.onSite(now.plus(settings.agreeEvery()), state.until()),
        List.of(new ToOne(state.chosen().robot(), new Agree(state.conversation()))));
  }

  /** Whoever was chosen has turned back, or never will be heard of. */
  private Step<RequesterState, RequesterAction> replace(
      RequesterState state, String why, Instant now) {
    String robot = state.chosen().robot();
    List<RequesterAction> actions = new ArrayList<>(List.of(new Replace(robot, why)));
    if (!now.isBefore(state.patience())) {
      actions.add(new End(false, robot + " " + why + ", and it is too late to call another"));
      return new Step<>(state.ended(), actions);
    }
    return open(state, state.wanted(), state.patience(), now, actions);
  }

  /** A responder has sent a message. One that is not to a requester is left alone. */
  public Step<RequesterState, RequesterAction> hear(
      RequesterState before, String from, RecruitmentMessage message, Instant now) {
    List<RequesterAction> actions = new ArrayList<>();
    RequesterState state = taken(tick(Parting.hear(before, from, message), now), actions);
    Step<RequesterState, RequesterAction> step =
        message.conversation().equals(state.conversation())
            ? hearNow(state, from, message, now)
            : hearOfThePast(state, from, message);
    return new Step<>(taken(step, actions), actions);
  }

  private static Step<RequesterState, RequesterAction> hearOfThePast(
      RequesterState state, String from, RecruitmentMessage message) {
    boolean wantsAnswer = message instanceof Accept || message instanceof Arrival;
    return wantsAnswer && state.conversation().supersedes(message.conversation())
        ? released(state, from, message.conversation())
        : Step.none(state);
  }

  private Step<RequesterState, RequesterAction> hearNow(
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
    return isConfirmed ? new Step<>(state.done(), List.of(new Complete(from))) : Step.none(state);
  }

  private Step<RequesterState, RequesterAction> accept(
      RequesterState state, String from, Accept accept, Instant now) {
    Bid bid = new Bid(from, accept.bid(), accept.eta(), accept.battery());
    return switch (state.phase()) {
      case CALLING ->
          new Step<>(
              state.collecting(List.of(bid), now.plus(settings.windowOr(chooser.window()))),
              List.of());
      case COLLECTING ->
          new Step<>(state.collecting(Bids.with(state.bids(), bid), state.due()), List.of());
      case AWARDED -> state.isWinner(from) ? remind(state, bid, now) : inform(state, from);
      case ON_SITE, DONE -> state.isWinner(from) ? Step.none(state) : inform(state, from);
      case IDLE -> released(state, from, state.conversation());
    };
  }

  /** It does not know yet that it was chosen. */
  private Step<RequesterState, RequesterAction> remind(RequesterState state, Bid bid, Instant now) {
    Bid chosen = state.chosen();
    Instant patience = patienceWith(bid.eta(), now);
    boolean isNews = bid.number() > chosen.number() && patience.isAfter(state.until());
    RequesterState next = isNews ? awarded(state, bid, patience) : state;
    return inform(next, bid.robot());
  }

  private static Step<RequesterState, RequesterAction> inform(RequesterState state, String robot) {
    Bid winner = state.chosen();
    return new Step<>(
        state,
        List.of(
            new ToOne(
                robot, new ResponderId(state.conversation(), winner.robot(), winner.number()))));
  }

  private Step<RequesterState, RequesterAction> refuse(
      RequesterState state, String from, Refuse refuse, Instant now) {
    if (!refuse.isFinal()) {
      return Step.none(state); // of an offer that it made since it says nothing
    }
    return switch (state.phase()) {
      case IDLE, CALLING -> Step.none(state);
      case COLLECTING -> withdraw(state, from, now);
      case AWARDED, ON_SITE ->
          state.isWinner(from)
              ? replace(state, "turned back: " + refuse.why(), now)
              : Step.none(state);
      case DONE ->
          state.isWinner(from)
              ? new Step<>(
                  state.ended(), List.of(new End(true, from + " has left: " + refuse.why())))
              : Step.none(state);
    };
  }

  private Step<RequesterState, RequesterAction> withdraw(
      RequesterState state, String from, Instant now) {
    List<Bid> left = Bids.without(state.bids(), from);
    return new Step<>(
        left.isEmpty()
            ? state.calling(state.round(), again(now, state.patience()))
            : state.collecting(left, state.due()),
        List.of());
  }

  private Step<RequesterState, RequesterAction> arrival(
      RequesterState state, String from, Arrival arrival, Instant now) {
    boolean isAwaited = state.isWinner(from);
    if (isAwaited && state.phase() == RequesterPhase.AWARDED) {
      Instant end = now.plus(arrival.stay());
      return new Step<>(
          state.onSite(now.plus(settings.agreeEvery()), end),
          List.of(
              new Hold(from, arrival.lease(), arrival.stay()),
              new ToOne(from, new Agree(state.conversation()))));
    }
    if (isAwaited && state.phase() == RequesterPhase.ON_SITE) {
      return new Step<>(state, List.of(new ToOne(from, new Agree(state.conversation()))));
    }
    return isAwaited && state.phase() == RequesterPhase.DONE
        ? Step.none(state)
        : released(state, from, arrival.conversation());
  }

  private static Step<RequesterState, RequesterAction> released(
      RequesterState state, String robot, Conversation which) {
    return new Step<>(
        state, List.of(new ToOne(robot, new Release(which, "that call is over", false))));
  }

  private static ToOne release(RequesterState state, String robot, String why) {
    return new ToOne(robot, new Release(state.conversation(), why, false));
  }
}
