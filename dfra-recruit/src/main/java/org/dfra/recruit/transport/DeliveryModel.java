package org.dfra.recruit.transport;

import java.util.random.RandomGenerator;
import org.dfra.recruit.loss.LossModel;
import org.dfra.recruit.message.MessageEnvelope;

/** What becomes of a letter to one robot. */
@FunctionalInterface
public interface DeliveryModel {

  double[] LOST = {};

  /** After how many seconds each copy of it comes; none where it is lost. */
  double[] copyDelays(String to, MessageEnvelope letter);

  /** It is lost, or comes once. */
  static DeliveryModel of(LossModel loss, DelayModel delay, RandomGenerator random) {
    return (to, letter) -> {
      double after = delay.next(random); // drawn for lost ones too: paired runs stay in step
      return loss.loses(letter.sender(), to) ? LOST : new double[] {after};
    };
  }
}
