package org.dfra.flow.perceptual;

import org.dfra.event.Reading;

/**
 * Something perceived: a reading that was made of others. Its time is that of the newest of them
 * that it rests on, so who acts on it knows how old it is.
 */
public interface Percept extends Reading {

  /** Name of the frame that its numbers are in. */
  String frame();
}
