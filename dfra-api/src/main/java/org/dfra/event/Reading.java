package org.dfra.event;

import java.io.Serializable;
import java.time.Instant;

/** A measured or computed value with its time. Immutable. */
public interface Reading extends Serializable {

  /** The time of the measurement, UTC; not the time of arrival. */
  Instant measured();
}
