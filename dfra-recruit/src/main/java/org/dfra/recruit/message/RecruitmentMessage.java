package org.dfra.recruit.message;

import java.io.Serializable;
import java.time.Duration;
import java.util.Objects;
import java.util.UUID;
import org.dfra.agent.HelpCall;

/**
 * A message of a conversation. Messages contain time spans, never instants: clocks may differ, and
 * a delayed message then errs on the safe side (see {@link ResponderId}).
 */
public sealed interface RecruitmentMessage extends Serializable {

  /** Its conversation. */
  Conversation conversation();

  /** Requester to all: a call for help. */
  record Help(Conversation conversation, HelpCall call, int round) implements RecruitmentMessage {

    /** {@code round} counts the calls of the conversation from 1. */
    public Help {
      Objects.requireNonNull(conversation, "conversation");
      Objects.requireNonNull(call, "call");
      if (round < 1) {
        throw new IllegalArgumentException("round " + round + " is below 1");
      }
    }
  }

  /**
   * Responder to requester: an offer.
   *
   * @param bid counts the offers of this robot in the conversation from 0
   * @param eta time to reach the place, not negative, at most {@link HelpCall#MAX_DURATION}
   * @param battery charge left, 0 is empty, 1 is full
   */
  record Accept(Conversation conversation, int bid, Duration eta, double battery)
      implements RecruitmentMessage {

    public Accept {
      Objects.requireNonNull(conversation, "conversation");
      boolean isEta = !eta.isNegative() && eta.compareTo(HelpCall.MAX_DURATION) <= 0;
      if (bid < 0 || !isEta || !(battery >= 0 && battery <= 1)) {
        throw new IllegalArgumentException(
            "an offer needs a bid of 0 or more, an arrival within "
                + HelpCall.MAX_DURATION.toSeconds()
                + " s and a battery of 0 to 1, not bid "
                + bid
                + ", arrival in "
                + eta.toSeconds()
                + " s, battery "
                + battery);
      }
    }
  }

  /**
   * Responder to requester: a refusal, a withdrawal, or the acknowledgement of a release.
   *
   * @param isFinal whether the responder has left the conversation; false where it only makes no
   *     offer in this round. Such a message may arrive after an offer of a later round
   */
  record Refuse(Conversation conversation, String why, boolean isFinal)
      implements RecruitmentMessage {

    public Refuse {
      Objects.requireNonNull(conversation, "conversation");
      Objects.requireNonNull(why, "why");
    }
  }

  /**
   * Requester to all: the chosen robot; the others are not needed.
   *
   * @param winner name of the robot
   * @param bid its latest offer that the requester has received. The requester waits for the winner
   *     until that offer's time has passed since it <em>received</em> it; the winner withdraws when
   *     the time has passed since it <em>sent</em> it, which is earlier.
   */
  record ResponderId(Conversation conversation, String winner, int bid)
      implements RecruitmentMessage {

    public ResponderId {
      Objects.requireNonNull(conversation, "conversation");
      Objects.requireNonNull(winner, "winner");
    }
  }

  /**
   * Responder to requester: the responder has arrived.
   *
   * @param lease identifies the lease that the responder grants on itself
   * @param stay remaining time, at most {@link HelpCall#MAX_DURATION}
   */
  record Arrival(Conversation conversation, UUID lease, Duration stay)
      implements RecruitmentMessage {

    public Arrival {
      Objects.requireNonNull(conversation, "conversation");
      Objects.requireNonNull(lease, "lease");
      if (stay.isNegative() || stay.compareTo(HelpCall.MAX_DURATION) > 0) {
        throw new IllegalArgumentException(
            "a helper stays 0 to "
                + HelpCall.MAX_DURATION.toSeconds()
                + " s, not "
                + stay.toSeconds()
                + " s");
      }
    }
  }

  /** Requester to responder: acknowledges the arrival and accepts the lease. */
  record Agree(Conversation conversation) implements RecruitmentMessage {

    public Agree {
      Objects.requireNonNull(conversation, "conversation");
    }
  }

  /** Responder to requester: acknowledges the agreement. The recruitment is complete. */
  record AckAck(Conversation conversation) implements RecruitmentMessage {

    public AckAck {
      Objects.requireNonNull(conversation, "conversation");
    }
  }

  /**
   * Requester to a responder, or to all: releases the receiver, or rejects its offer.
   *
   * @param wantsAnswer whether the receiver must acknowledge it by a REFUSE
   */
  record Release(Conversation conversation, String why, boolean wantsAnswer)
      implements RecruitmentMessage {

    public Release {
      Objects.requireNonNull(conversation, "conversation");
      Objects.requireNonNull(why, "why");
    }
  }
}
