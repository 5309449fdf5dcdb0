package org.dfra.event;

import java.io.Serializable;
import java.time.Instant;

/** Something measured or computed, with the time it belongs to. Immutable. */
public interface Reading extends Serializable {

  /** The time that the reading is of, UTC; not the time it arrived. */
  Instant measured();
}
