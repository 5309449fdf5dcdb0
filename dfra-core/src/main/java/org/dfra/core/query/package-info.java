/**
 * Queries as people write them.
 *
 * <pre>
 *   "GPSSensor on atrv1 with sensor.maxRate &gt;= 1" --QueryParser--&gt; ModuleQuery
 * </pre>
 *
 * <p>Enter at {@link org.dfra.core.query.QueryParser}; what names it knows is its {@link
 * org.dfra.core.query.QueryVocabulary}.
 */
@NullMarked
package org.dfra.core.query;

import org.jspecify.annotations.NullMarked;
