/**
 * Parses textual queries.
 *
 * <pre>
 *   "GPSSensor on atrv1 with sensor.maxRate &gt;= 1" --QueryParser--&gt; ModuleQuery
 * </pre>
 *
 * <p>Start at {@link org.dfra.core.query.QueryParser}; its {@link
 * org.dfra.core.query.QueryTypeNames} defines the valid names.
 */
@NullMarked
package org.dfra.core.query;

import org.jspecify.annotations.NullMarked;
