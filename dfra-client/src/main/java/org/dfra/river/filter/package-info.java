/**
 * Deserialization filters: they limit the objects that data from unknown clients may create in this
 * virtual machine.
 *
 * <pre>
 *   arguments -&gt; FilteredInvocationDispatcher -&gt; StreamScanner -&gt; CallFilter: MethodTypes
 *   results ---&gt; DeadlineInvocationHandler ----&gt; StreamScanner -&gt; ObjectGraphFilter
 *   MarshalledInstance, events, lookup,               | bytes: limits, hash tables
 *   anything else -&gt; SerialFilterFactory -------------+---------&gt; ObjectGraphFilter
 *                    (SerialFilters.install())        |              | classes: AllowedTypes
 *                                                     v              v
 *                                        RefusedDataException, nothing is deserialized
 * </pre>
 *
 * <p>The contents of marshalled objects in a call or in its result are checked together with it,
 * since River unmarshals them later without a check. Other code that receives marshalled objects
 * first calls {@link org.dfra.river.filter.SerialFilters#check}.
 *
 * <p>Every stream has the network's limits. Code that reads a file must declare it: {@link
 * org.dfra.river.filter.SerialFilters#guardStored} for a stream, {@link
 * org.dfra.river.filter.SerialFilters#readStored} around code that opens its own streams.
 *
 * <p>Enter at {@link org.dfra.river.filter.SerialFilters}. Clients download the package, since a
 * downloaded proxy filters its results too: it needs the JDK and River only.
 */
@NullMarked
package org.dfra.river.filter;

import org.jspecify.annotations.NullMarked;
