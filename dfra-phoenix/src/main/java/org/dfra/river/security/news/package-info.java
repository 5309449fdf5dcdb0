/**
 * How lists of revoked certificates and policies reach all members of a team without a server: a
 * process that has newer ones gives them to each process that it talks to.
 *
 * <p>Start at {@link org.dfra.river.security.news.TeamNews}, which each process with an identity
 * exports, and {@link org.dfra.river.security.news.NewsExchange}, which calls it. The authority has
 * signed and numbered these, so it does not matter who passes them on.
 *
 * <p>By the same calls members exchange the signed ends of their audit trails, which {@link
 * org.dfra.river.security.news.HeadFiles} keeps.
 */
@NullMarked
package org.dfra.river.security.news;

import org.jspecify.annotations.NullMarked;
