/**
 * Deserialization filters: what a stranger may make this virtual machine build.
 *
 * <pre>
 *   call arguments --&gt; FilteredInvocationDispatcher --&gt; StreamScanner --&gt; CallFilter: MethodTypes
 *   call results ----&gt; DeadlineInvocationHandler -----&gt; StreamScanner --&gt; ObjectGraphFilter
 *   MarshalledInstance, events, lookup results,               | bytes: limits, hash tables,
 *   anything else ---&gt; SerialFilterFactory -------------------+-------&gt; ObjectGraphFilter
 *                      (SerialFilters.install())              |            | classes: AllowedTypes
 *                                                             v            v
 *                                                RefusedDataException, nothing is built
 * </pre>
 *
 * <p>What marshalled objects in a call or in its result hold is checked with them, since River
 * unpacks those by itself later; what else brings any has {@link
 * org.dfra.river.filter.SerialFilters#check} look first.
 *
 * <p>Every stream has the network's limits. What reads a file says so: {@link
 * org.dfra.river.filter.SerialFilters#guardStored} for a stream, {@link
 * org.dfra.river.filter.SerialFilters#readStored} around code that makes its streams itself.
 *
 * <p>Enter at {@link org.dfra.river.filter.SerialFilters}. The package is part of the {@code -dl}
 * jar, since a downloaded proxy filters its results too: it needs the JDK and River only.
 */
@NullMarked
package org.dfra.river.filter;

import org.jspecify.annotations.NullMarked;
