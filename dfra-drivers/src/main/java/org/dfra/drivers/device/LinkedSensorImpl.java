package org.dfra.drivers.device;

import java.time.Duration;
import java.util.List;
import org.dfra.core.module.LatestReading;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.SensorImpl;
import org.dfra.drivers.link.ReopeningLink;
import org.dfra.drivers.link.Ticker;
import org.dfra.module.Precondition;

/**
 * Common base of the drivers of sensors behind a link: the last reading, and the link that brings
 * it, open from start to close.
 *
 * @param <T> type of its readings; immutable
 */
public abstract class LinkedSensorImpl<T> extends SensorImpl {

  private final LatestReading<T> latest;

  /**
   * See {@link SensorImpl}.
   *
   * @param outputTypes the types of its readings, by the simple names of their classes
   * @param preconditions the required conditions of its environment
   * @param reading name of a reading in messages: {@code scan}, {@code position}
   * @param ticker the clock of a reading's age
   */
  protected LinkedSensorImpl(
      ModuleContext context,
      String description,
      List<String> outputTypes,
      List<Precondition> preconditions,
      String reading,
      Ticker ticker) {
    super(context, description, "DFRA", "1.0", outputTypes, preconditions);
    this.latest =
        new LatestReading<>(reading, this, this::transitionTo, ticker::nanos, this::longestAge);
  }

  /** The link that brings its readings; always the same. */
  protected abstract ReopeningLink link();

  /** Current maximum age of a served reading; from any thread. */
  protected abstract Duration longestAge();

  /** The last reading; only the link's reader modifies it. */
  protected final LatestReading<T> latest() {
    return latest;
  }

  @Override
  protected final void onStart() {
    latest.setMissing("its link is being opened");
    link().start();
  }

  @Override
  protected void onClose() {
    link().close();
    latest.clear("it has ended");
  }
}
