package org.dfra.river.filter;

import java.io.ObjectInputFilter;
import java.util.function.BinaryOperator;
import org.jspecify.annotations.Nullable;

/**
 * Gives every object stream of the virtual machine a filter (JEP 415).
 *
 * <p>The source of a stream is not guessed: each has the network's limits, unless the thread that
 * creates it is {@linkplain SerialFilters#readStored reading data that this computer stored}.
 *
 * <p>{@link SerialFilters#install()} installs it; a virtual machine whose main class is not DFRA's
 * gets it by {@code -Djdk.serialFilterFactory=org.dfra.river.filter.SerialFilterFactory}.
 */
public final class SerialFilterFactory implements BinaryOperator<@Nullable ObjectInputFilter> {

  /** The JDK requires this constructor when a system property names the class. */
  public SerialFilterFactory() {}

  /**
   * @param current the stream's filter, null while it is constructed
   * @param next the virtual machine's filter while it is constructed, else the filter that its
   *     owner sets
   */
  @Override
  public ObjectInputFilter apply(
      @Nullable ObjectInputFilter current, @Nullable ObjectInputFilter next) {
    if (current == null) {
      ObjectGraphFilter ours = SerialFilters.newStreamFilter();
      return next == null ? ours : new Both(next, ours);
    }
    if (next == null) {
      return current;
    }
    if (next instanceof ObjectGraphFilter) { // the filter of a call: replaces the general one
      return current instanceof Both both ? new Both(both.theirs(), next) : next;
    }
    return new Both(next, current);
  }

  /** Refuses what one of two filters refuses; the owner's filter is called first. */
  private record Both(ObjectInputFilter theirs, ObjectInputFilter ours)
      implements ObjectInputFilter {
    @Override
    public Status checkInput(FilterInfo info) {
      Status first = theirs.checkInput(info);
      if (first == Status.REJECTED) {
        return first;
      }
      Status second = ours.checkInput(info);
      return second == Status.UNDECIDED ? first : second;
    }
  }
}
