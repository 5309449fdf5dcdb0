package org.dfra.recruit.transport;

import java.util.random.RandomGenerator;
import org.dfra.recruit.loss.LossModel;
import org.dfra.recruit.message.MessageEnvelope;

/** Models the delivery of a message to one robot. */
@FunctionalInterface
public interface DeliveryModel {

  double[] LOST = {};

  /** The delay of each copy, seconds; none where it is lost. */
  double[] copyDelays(String to, MessageEnvelope envelope);

  /** A message is lost, or delivered once. */
  static DeliveryModel of(LossModel loss, DelayModel delay, RandomGenerator random) {
    return (to, envelope) -> {
      double after = delay.next(random); // drawn for lost ones too: paired runs stay aligned
      return loss.loses(envelope.sender(), to) ? LOST : new double[] {after};
    };
  }
}
