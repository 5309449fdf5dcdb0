package org.dfra.recruit.loss;

/** Decides which messages are lost. */
@FunctionalInterface
public interface LossModel {

  /** Whether the next message from one robot to another is lost. */
  boolean loses(String from, String to);

  /** No loss. */
  static LossModel none() {
    return (from, to) -> false;
  }
}
