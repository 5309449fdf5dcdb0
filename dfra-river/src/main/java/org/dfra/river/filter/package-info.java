/**
 * Deserialization filters: what a stranger may make this virtual machine build.
 *
 * <pre>
 *   call arguments ---&gt; FilteredInvocationDispatcher --\
 *   call results -----&gt; DeadlineInvocationHandler ------+--&gt; GraphFilter: SerialLimits, AllowedTypes
 *   MarshalledInstance, events, lookup results,         |      | class, array or depth not allowed
 *   anything else ----&gt; SerialFilterFactory -----------/       v
 *                       (SerialFilters.install())           RefusedDataException, nothing is built
 * </pre>
 *
 * <p>Every stream has the network's limits. What reads a file says so: {@link
 * org.dfra.river.filter.SerialFilters#guardStored} for a stream, {@link
 * org.dfra.river.filter.SerialFilters#readingStored} around code that makes its streams itself.
 *
 * <p>Enter at {@link org.dfra.river.filter.SerialFilters}. The package is part of the {@code -dl}
 * jar, since a downloaded proxy filters its results too: it needs the JDK and River only.
 */
@NullMarked
package org.dfra.river.filter;

import org.jspecify.annotations.NullMarked;
