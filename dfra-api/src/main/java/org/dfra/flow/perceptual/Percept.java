package org.dfra.flow.perceptual;

import org.dfra.event.Reading;

/**
 * A reading that is computed from other readings. Its time is that of the newest reading it is
 * based on, so consumers can compute its age.
 */
public interface Percept extends Reading {

  /** Name of the frame of its values. */
  String frame();
}
