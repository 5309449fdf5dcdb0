/** Log levels of modules, which can be changed at run time. */
@NullMarked
package org.dfra.core.log;

import org.jspecify.annotations.NullMarked;
