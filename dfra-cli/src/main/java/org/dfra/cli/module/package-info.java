/** The subcommands of {@code ./dfra module}: queries and changes of modules. */
@NullMarked
package org.dfra.cli.module;

import org.jspecify.annotations.NullMarked;
