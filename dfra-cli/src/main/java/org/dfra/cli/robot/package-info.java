/** Brings the robots of this host up and down, and shows their status. */
@NullMarked
package org.dfra.cli.robot;

import org.jspecify.annotations.NullMarked;
