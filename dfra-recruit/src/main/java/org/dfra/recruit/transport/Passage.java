package org.dfra.recruit.transport;

import java.util.random.RandomGenerator;
import org.dfra.recruit.loss.LossModel;
import org.dfra.recruit.message.Letter;

/** What becomes of a letter to one robot. */
@FunctionalInterface
public interface Passage {

  double[] LOST = {};

  /** After how many seconds each copy of it comes; none where it is lost. */
  double[] copies(String to, Letter letter);

  /** It is lost, or comes once. */
  static Passage of(LossModel loss, DelayModel delay, RandomGenerator lot) {
    return (to, letter) -> {
      double after = delay.next(lot); // drawn for lost ones too: paired runs stay in step
      return loss.loses(letter.sender(), to) ? LOST : new double[] {after};
    };
  }
}
