/** The login module of {@code docs/reference/jaas.md}; {@code LoginFlagsTest} logs in with it. */
@NullMarked
package org.dfra.example.login;

import org.jspecify.annotations.NullMarked;
