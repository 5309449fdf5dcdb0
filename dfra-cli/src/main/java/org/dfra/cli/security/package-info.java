/**
 * The verbs {@code security join}, {@code security show} and {@code whoami}: how a computer joins a
 * team, and who its commands and robots are then. Start at {@link
 * org.dfra.cli.security.IdentityInstaller}, which writes the folder of an identity from a {@link
 * org.dfra.cli.security.Bundle}.
 */
@NullMarked
package org.dfra.cli.security;

import org.jspecify.annotations.NullMarked;
