package org.dfra.recruit.message;

import java.io.Serializable;
import java.time.Duration;
import java.util.Objects;
import java.util.UUID;
import org.dfra.agent.HelpCall;

/**
 * What is said in a conversation. Time spans cross the network, instants never do: clocks may
 * differ, and a message that took its time then errs on the safe side (see {@link ResponderId}).
 */
public sealed interface RecruitmentMessage extends Serializable {

  /** In which conversation. */
  Conversation conversation();

  /** Requester to all: who can come? */
  record Help(Conversation conversation, HelpCall call, int round) implements RecruitmentMessage {

    /** {@code round} counts the calls of the conversation from 1. */
    public Help {
      Objects.requireNonNull(conversation, "conversation");
      Objects.requireNonNull(call, "call");
      if (round < 1) {
        throw new IllegalArgumentException("round " + round + " is not >= 1");
      }
    }
  }

  /**
   * Responder to requester: I can.
   *
   * @param bid counts the offers of this robot in the conversation from 0
   * @param eta how long it would take to be there, not negative, at most {@link
   *     HelpCall#MAX_DURATION}
   * @param battery charge left, 0 is empty, 1 is full
   */
  record Accept(Conversation conversation, int bid, Duration eta, double battery)
      implements RecruitmentMessage {

    public Accept {
      Objects.requireNonNull(conversation, "conversation");
      boolean isEta = !eta.isNegative() && eta.compareTo(HelpCall.MAX_DURATION) <= 0;
      if (bid < 0 || !isEta || !(battery >= 0 && battery <= 1)) {
        throw new IllegalArgumentException(
            "bid " + bid + ", " + eta.toSeconds() + " s, battery " + battery + " is no offer");
      }
    }
  }

  /**
   * Responder to requester: I cannot, or not any more, or I know that I need not.
   *
   * @param isFinal whether it is out of the conversation from then on; false where it only makes no
   *     offer in this round. Such a one may come after an offer that it made in a later round
   */
  record Refuse(Conversation conversation, String why, boolean isFinal)
      implements RecruitmentMessage {

    public Refuse {
      Objects.requireNonNull(conversation, "conversation");
      Objects.requireNonNull(why, "why");
    }
  }

  /**
   * Requester to all: that one is to come, the others need not.
   *
   * @param winner name of the robot
   * @param bid the latest offer of it that the requester has heard. It waits for the winner until
   *     that offer's time has passed since it <em>heard</em> it; the winner turns back when the
   *     time has passed since it <em>sent</em> it, which was before.
   */
  record ResponderId(Conversation conversation, String winner, int bid)
      implements RecruitmentMessage {

    public ResponderId {
      Objects.requireNonNull(conversation, "conversation");
      Objects.requireNonNull(winner, "winner");
    }
  }

  /**
   * Responder to requester: I am there.
   *
   * @param lease names the lease that the responder grants on itself
   * @param stay for how long yet, at most {@link HelpCall#MAX_DURATION}
   */
  record Arrival(Conversation conversation, UUID lease, Duration stay)
      implements RecruitmentMessage {

    public Arrival {
      Objects.requireNonNull(conversation, "conversation");
      Objects.requireNonNull(lease, "lease");
      if (stay.isNegative() || stay.compareTo(HelpCall.MAX_DURATION) > 0) {
        throw new IllegalArgumentException(
            "a lease of " + stay.toSeconds() + " s has ended, or never does");
      }
    }
  }

  /** Requester to responder: I know that you are there; stay. */
  record Agree(Conversation conversation) implements RecruitmentMessage {

    public Agree {
      Objects.requireNonNull(conversation, "conversation");
    }
  }

  /** Responder to requester: I know that you know. The recruitment is complete. */
  record AckAck(Conversation conversation) implements RecruitmentMessage {

    public AckAck {
      Objects.requireNonNull(conversation, "conversation");
    }
  }

  /**
   * Requester to a responder, or to all: you are not wanted any more, or never were.
   *
   * @param wantsAnswer whether who hears it is to say so by a REFUSE
   */
  record Release(Conversation conversation, String why, boolean wantsAnswer)
      implements RecruitmentMessage {

    public Release {
      Objects.requireNonNull(conversation, "conversation");
      Objects.requireNonNull(why, "why");
    }
  }
}
