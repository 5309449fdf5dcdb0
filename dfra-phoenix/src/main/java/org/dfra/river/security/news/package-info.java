/**
 * How lists of revoked certificates and policies reach all members of a team without a server: a
 * process that has newer ones gives them to each process that it talks to.
 *
 * <p>Start at {@link org.dfra.river.security.news.TeamNews}, which each process with an identity
 * exports, and {@link org.dfra.river.security.news.NewsExchange}, which calls it. The authority has
 * signed and numbered everything that is passed on, so it does not matter who passes it on.
 */
@NullMarked
package org.dfra.river.security.news;

import org.jspecify.annotations.NullMarked;
